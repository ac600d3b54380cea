package campaign;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The messages from one host to another, as the logs of both tell them.
 *
 * @param offered   messages that the first handed to its board.
 * @param delivered those that were reported delivered.
 * @param lost      reported delivered, and not in the second's log.
 * @param redelivered handed over once more to a later run of the second host, with the same id: SPEC 7.2 allows it,
 *                  since the run before died before it had said that it has the message.
 * @param twice     handed over twice otherwise.
 * @param wrong     handed over, but never sent like this.
 * @param stuck     neither refused nor ended although the host waited for it.
 */
record Account(long offered, long delivered, long lost, long redelivered, long twice, long wrong, long stuck) {

    static final Account EMPTY = new Account(0, 0, 0, 0, 0, 0, 0);

    /** A message handed to a host. */
    private record Handed(int run, String id) {}

    static Account of(HostLog sender, HostLog receiver) throws IOException {
        Set<String> offered = new HashSet<>();
        Set<String> delivered = new HashSet<>();
        long stuck = 0;
        for (String line : sender.lines()) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "offered" -> offered.add(words[1]);
                case "ended" -> {
                    if (words[2].equals("DELIVERED")) {
                        delivered.add(words[1]);
                    }
                }
                case "stuck" -> stuck += Long.parseLong(words[1]);
                default -> {}
            }
        }
        Map<String, List<Handed>> handed = handed(receiver);
        long wrong = receiver.lines().stream().filter(line -> line.startsWith("wrong ")).count()
                + handed.keySet().stream().filter(number -> !offered.contains(number)).count();
        long lost = delivered.stream().filter(number -> !handed.containsKey(number)).count();
        long redelivered = 0;
        long twice = 0;
        for (List<Handed> times : handed.values()) {
            for (int i = 1; i < times.size(); i++) {
                boolean allowed =
                        times.get(i).run > times.get(i - 1).run && times.get(i).id.equals(times.get(i - 1).id);
                redelivered += allowed ? 1 : 0;
                twice += allowed ? 0 : 1;
            }
        }
        return new Account(offered.size(), delivered.size(), lost, redelivered, twice, wrong, stuck);
    }

    private static Map<String, List<Handed>> handed(HostLog receiver) throws IOException {
        Map<String, List<Handed>> handed = new HashMap<>();
        int run = 0;
        for (String line : receiver.lines()) {
            String[] words = line.split(" ");
            if (HostLog.isRun(line)) {
                run++;
            }
            if (words[0].equals("received")) {
                handed.computeIfAbsent(words[1], any -> new ArrayList<>()).add(new Handed(run, words[2]));
            }
        }
        return handed;
    }

    Account plus(Account other) {
        return new Account(offered + other.offered, delivered + other.delivered, lost + other.lost,
                redelivered + other.redelivered,
                twice + other.twice, wrong + other.wrong, stuck + other.stuck);
    }
}
