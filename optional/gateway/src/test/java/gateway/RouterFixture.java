package gateway;

import gateway.Router.Whom;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javino.Counts;
import javino.protocol.Address;
import javino.protocol.Bytes;

/** A router of the cell west, and what it does. */
abstract class RouterFixture {

    static final long STEP = 600;

    final Counts<GatewayCounter> counters = new Counts<>();
    final List<Bytes> relayed = new ArrayList<>();
    /** All other effects, such as {@code CELL east 1}, {@code seek ROMA}, {@code serve ROMA}. */
    final List<String> done = new ArrayList<>();
    Router router = router(false);
    long now = 1_000_000;

    Router router(boolean broadcasts, String... groups) {
        Set<Address> wanted = Set.of(java.util.Arrays.stream(groups).map(Address::multicast).toArray(Address[]::new));
        return new Router("west", broadcasts, wanted, counters, 0);
    }

    void step(RouterEvent event) {
        for (RouterEffect effect : router.step(event, now)) {
            if (effect instanceof RouterEffect.Relay relay) {
                relayed.add(relay.frame().encode());
                step(new RouterEvent.Relayed(true));
            } else if (effect instanceof RouterEffect.Publish publish) {
                done.add(publish.whom() + " " + publish.name() + " " + publish.attempt());
            } else if (effect instanceof RouterEffect.Ask ask) {
                done.add("seek " + ask.device());
            } else if (effect instanceof RouterEffect.Tell tell) {
                done.add("tell " + tell.cell() + " " + tell.device() + " " + tell.age());
            } else if (effect instanceof RouterEffect.Serve serve) {
                done.add((serve.wanted() ? "serve " : "leave ") + serve.address());
            }
        }
    }

    /** Whether a frame that the board has heard goes to the broker. */
    boolean heard(Bytes frame) {
        now += STEP;
        int before = done.size();
        step(new RouterEvent.Heard(frame));
        return done.subList(before, done.size()).stream().anyMatch(each -> each.matches("[A-Z]{3,} .*"));
    }

    /** The cells for which a frame that the board has heard goes to the broker, and the devices that are sought. */
    List<String> publishes(Bytes frame) {
        int before = done.size();
        heard(frame);
        return done.subList(before, done.size()).stream().filter(each -> !each.matches("(serve|tell) .*")).toList();
    }

    /** Whether a frame from another cell is relayed. */
    boolean relays(String cell, Whom whom, int attempt, Bytes frame) {
        now += STEP;
        int before = relayed.size();
        step(new RouterEvent.Arrived(cell, whom, attempt, frame, now + Router.LIFE_MILLIS, true));
        return relayed.size() == before + 1 && relayed.get(before).equals(frame);
    }

    boolean relays(Whom whom, Bytes frame) {
        return relays("east", whom, 0, frame);
    }

    boolean relays(Bytes frame) {
        return relays(Whom.CELL, frame);
    }

    void told(String cell, String device, long age) {
        step(new RouterEvent.Told(cell, Address.parse(device), age));
    }

    static List<Boolean> times(int count) {
        return IntStream.range(0, count).mapToObj(any -> true).toList();
    }
}
