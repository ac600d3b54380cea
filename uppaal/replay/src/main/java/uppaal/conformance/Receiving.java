package uppaal.conformance;

import java.util.Map;

/** A message at a receiver's board, which takes it for a broadcast until its host has got it. */
final class Receiving {
    private static final int DATA = 1;
    private static final int ACK = 2;
    private static final int QUESTION = 6;

    final int number;
    final int key;
    private final DeliveryModels models;
    private final int nonce;
    private final Instance instance;

    Receiving(DeliveryModels models, int number, Point queued) throws RefusedException {
        this.models = models;
        this.number = number;
        nonce = queued.operand("nonce");
        key = queued.operand("key");
        instance = models.receiver("broadcast", number);
        see(queued);
    }

    /** The board owes an answer to one that it does not have. */
    static void unknown(DeliveryModels models, Point owes) throws RefusedException {
        models.receiver("unicast", owes.operand("nonce")).take(owes, owes.name(),
                DeliveryModels.outside(Map.of("kind", owes.is("OWE_FRAGMENTS") ? QUESTION : DATA)));
    }

    /** Whether an answer is owed to it. */
    boolean isOf(Point answer) {
        return key == answer.operand("key") && nonce == answer.operand("nonce");
    }

    /** The host has got it, and so its kind is known. */
    void isOfKind(String kind) {
        instance.become(models.receiver(kind, number));
    }

    boolean isHanded() {
        return !instance.isAt("Queued");
    }

    /** @param isNext whether all before it were handed over */
    void hand(Point point, boolean isNext) throws RefusedException {
        instance.set("unread[0]", DeliveryModels.flag(!isNext));
        see(point);
    }

    /**
     * Its board declares something of it, or the host does something with it. While the host takes it, the board may
     * answer a poll that was repeated before that.
     */
    void see(Point point) throws RefusedException {
        boolean isRepeat = (point.is("host-taking") || point.is("HANDED")) && instance.isAt("Taking");
        if (!isRepeat) {
            instance.take(point, point.name(), DeliveryModels.outside(Map.of("kind", DATA)));
        }
    }

    /** Whether it is a unicast that the host has taken. */
    boolean isAcknowledged() {
        return instance.get("owed[1]") == ACK;
    }

    /** The acknowledgement that taking it causes. */
    void acknowledge(Point point) throws RefusedException {
        point.require(point.is("OWE_DELIVERED") && isOf(point),
                "OWE_DELIVERED for message " + number + ", which its host has taken");
    }
}
