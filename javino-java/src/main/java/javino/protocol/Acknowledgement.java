package javino.protocol;

import java.security.MessageDigest;

/** What a receiver's board answers to a sealed frame, with a proof that it has the key (SPEC 7.3). */
public sealed interface Acknowledgement {

    /** The bytes of a proof. */
    int PROOF_LENGTH = 8;

    /**
     * The frame that is answered.
     *
     * @param key    with which it was sealed.
     * @param sender its origin.
     * @param nonce  its N, 6 bytes.
     */
    record Answered(Key key, Address sender, Bytes nonce) {

        /** @throws IllegalArgumentException if the nonce has not 6 bytes. */
        public Answered {
            check(nonce.length() == Nonce.LENGTH, "a nonce has 6 bytes, not " + nonce.length());
        }

        /** {@code +K} and the last 12 bits of the nonce. */
        Address address() {
            return new Address(Address.ACKNOWLEDGEMENT_GROUP << 12 | (int) nonce.number(4, 6) & 0xFFF);
        }

        Bytes proof(Address acknowledger, int type, Bytes body) {
            return Aes.cmac(key.authentication(), Bytes.join(Bytes.of(type), nonce, sender.toBytes(),
                    acknowledger.toBytes(), body)).slice(0, PROOF_LENGTH);
        }
    }

    /** The receiver's host has taken the message. */
    record Delivered() implements Acknowledgement {

        private static final int TYPE = 0x06;
        private static final int LENGTH = 0;

        @Override
        public int type() {
            return TYPE;
        }

        @Override
        public Bytes body() {
            return Bytes.EMPTY;
        }
    }

    /** @param received 0…0xFF: bit k is set where piece k is there. */
    record Pieces(int received) implements Acknowledgement {

        private static final int TYPE = 0x07;
        private static final int LENGTH = 1;

        /** @throws IllegalArgumentException if there are other bits. */
        public Pieces {
            check(received >= 0 && received <= 0xFF, "there are at most 8 pieces, not the bits of " + received);
        }

        @Override
        public int type() {
            return TYPE;
        }

        @Override
        public Bytes body() {
            return Bytes.of(received);
        }
    }

    /**
     * The receiver lost its memory and accepts only what is above the floor.
     *
     * @param floor  6 bytes, as a nonce.
     * @param uptime of the receiver in units of 0.1 s; 0xFFFF for all that is more.
     */
    record Stale(Bytes floor, int uptime) implements Acknowledgement {

        private static final int TYPE = 0x08;
        private static final int LENGTH = Nonce.LENGTH + 2;

        /** @throws IllegalArgumentException if the floor has not 6 bytes, or the uptime does not fit two. */
        public Stale {
            check(floor.length() == Nonce.LENGTH, "a floor has 6 bytes, not " + floor.length());
            check(uptime >= 0 && uptime <= 0xFFFF, "an uptime is 0…65535 units of 0.1 s, not " + uptime);
        }

        @Override
        public int type() {
            return TYPE;
        }

        @Override
        public Bytes body() {
            return Bytes.join(floor, Bytes.ofNumber(uptime, 2));
        }
    }

    private static void check(boolean condition, String complaint) {
        if (!condition) {
            throw new IllegalArgumentException(complaint);
        }
    }

    /** The byte that keeps the proofs of one kind from being those of another. */
    int type();

    /** What comes before the proof. */
    Bytes body();

    /** The acknowledgement as it goes on the air. */
    default Frame frame(Answered answered, Address acknowledger) {
        return new Frame(answered.address(), acknowledger,
                Bytes.join(body(), answered.proof(acknowledger, type(), body())));
    }

    /**
     * Reads the answer to a frame; whether its origin was asked is for the caller to judge.
     *
     * @throws ProtocolException BAD_PROOF if it is no answer to this frame, or not from one who has the key.
     */
    static Acknowledgement open(Answered answered, Frame frame) throws ProtocolException {
        expect(frame.destination().equals(answered.address()), "it answers another frame", frame);
        int bodyLength = frame.message().length() - PROOF_LENGTH;
        expect(bodyLength == Delivered.LENGTH || bodyLength == Pieces.LENGTH || bodyLength == Stale.LENGTH,
                "its message has not 8, 9 or 16 bytes", frame);
        Acknowledgement opened = read(frame.message().slice(0, bodyLength));
        Bytes expected = answered.proof(frame.origin(), opened.type(), opened.body());
        expect(MessageDigest.isEqual(expected.toArray(), frame.message().from(bodyLength).toArray()),
                "its proof is wrong", frame);
        return opened;
    }

    private static Acknowledgement read(Bytes body) {
        return switch (body.length()) {
            case Delivered.LENGTH -> new Delivered();
            case Pieces.LENGTH -> new Pieces(body.at(0));
            default -> new Stale(body.slice(0, Nonce.LENGTH), (int) body.number(Nonce.LENGTH, Stale.LENGTH));
        };
    }

    private static void expect(boolean condition, String complaint, Frame frame) throws ProtocolException {
        if (!condition) {
            throw new ProtocolException(ProtocolError.BAD_PROOF, complaint + ": " + frame.encode().hex());
        }
    }
}
