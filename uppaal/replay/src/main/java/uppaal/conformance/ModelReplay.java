package uppaal.conformance;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import trace.TraceEvent;

/** Each message's sender, receivers and answers do what {@code delivery.xml} lets them do, when it lets them. */
final class ModelReplay implements Check {
    private static final String ALL = "////";
    private static final String GROUP = "//";

    private final DeliveryModels models = new DeliveryModels();
    private final Map<String, ModelBoard> boards = new HashMap<>();
    private final Header header;

    ModelReplay(Header header) {
        this.header = header;
    }

    private ModelBoard board(String name) {
        return boards.computeIfAbsent(name, added -> new ModelBoard(models, new BoardAir(header, name)));
    }

    @Override
    public void point(Point point) throws RefusedException {
        board(point.board()).point(point);
    }

    @Override
    public void event(TraceEvent event) throws RefusedException {
        Point told = new Point(event, event.name(), 0, List.of());
        switch (event.name()) {
            case "crash" -> throw new RefusedException(event.board() + "'s program crashes", "that it runs on");
            case "reset" -> board(event.board()).reset();
            case "host-transmit" ->
                board(event.board()).transmit(event.number("number"), kind(event), event.seconds());
            case "host-relay" -> board(event.board()).transmit(event.number("number"), "broadcast", event.seconds());
            case "host-handed" -> board(event.board()).handed(told, event.number("number"), kind(event));
            case "host-taking" -> board(event.board()).takes(told, event.number("number"));
            default -> {}
        }
    }

    private static String kind(TraceEvent event) {
        String destination = event.text("destination");
        return destination.equals(ALL) ? "broadcast" : destination.startsWith(GROUP) ? "multicast" : "unicast";
    }

    @Override
    public Set<String> covered() {
        return models.covered();
    }
}
