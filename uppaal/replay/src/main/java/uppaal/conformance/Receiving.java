package uppaal.conformance;

import static uppaal.conformance.RefusedException.require;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** A message at a receiver's board. It is followed once its kind is known, when the host has got it. */
final class Receiving {
    private static final int DATA = 1;
    private static final int ACK = 2;

    private final DeliveryModels models;
    final int number;
    final int key;
    private final int nonce;
    private final List<Point> before = new ArrayList<>();
    private Instance instance;
    boolean isHanded;
    /** Whether taking it is to be acknowledged; only what its host has got is known to be a unicast. */
    boolean isUnicast;

    Receiving(DeliveryModels models, int number, Point queued) {
        this.models = models;
        this.number = number;
        nonce = queued.operand("nonce");
        key = queued.operand("key");
        before.add(queued);
    }

    /** Whether an answer is owed to it. */
    boolean isOf(Point answer) {
        return key == answer.operand("key") && nonce == answer.operand("nonce");
    }

    /** The host has got it, and so its kind is known. */
    void isOfKind(String kind, Point handed) throws RefusedException {
        require(isHanded, handed.board() + " hands over message " + number, "HANDED first");
        if (instance == null) {
            isUnicast = kind.equals("unicast");
            instance = models.receiver(kind, number);
            for (Point point : before) {
                take(point);
            }
        }
    }

    /**
     * Its board declares something of it, or the host does something with it.
     *
     * @param isNext whether the host has got all before it
     */
    void see(Point point, boolean isNext) throws RefusedException {
        if (point.is("HANDED")) {
            point.require(isHanded || isNext, "those before it first");
            isHanded = true;
        }
        if (instance == null) {
            before.add(point);
        } else {
            take(point);
        }
    }

    /** The acknowledgement that taking it causes. */
    void acknowledge(Point point) throws RefusedException {
        point.require(point.is("OWE_DELIVERED") && isOf(point) && instance.get("owed[1]") == ACK,
                "OWE_DELIVERED for message " + number + ", which its host has taken");
    }

    private void take(Point point) throws RefusedException {
        boolean isRepeat = point.is("host-taking") && instance.isAt("Taking");
        if (!isRepeat) {
            instance.take(point, point.name(), DeliveryModels.outside(Map.of("kind", DATA)));
        }
    }
}
