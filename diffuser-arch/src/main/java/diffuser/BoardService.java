package diffuser;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import diffuser.board.KeyService;
import diffuser.board.MoveService;

import javino.link.Time;

/**
 * A service that a library on the class path offers by an agent's board, often also a {@link MoveService} or a
 * {@link KeyService}. Java's {@link java.util.ServiceLoader} finds it.
 */
public interface BoardService {

    /** Makes the service of an agent with a board. */
    interface Maker {

        /** @param diffuser the owner of the board; the call comes when it is made, before its agent runs. */
        BoardService of(Diffuser diffuser);
    }

    /** Its entries in the agent's status. */
    Map<String, Object> status();

    /** Counters as a status has them, such as {@code movesCame}. */
    static <E extends Enum<E>> Map<String, Object> status(String prefix, Class<E> counted, ToLongFunction<E> count) {
        Map<String, Object> status = new LinkedHashMap<>();
        for (E each : counted.getEnumConstants()) {
            status.put(Stream.of(each.name().split("_"))
                    .map(word -> word.charAt(0) + word.substring(1).toLowerCase(Locale.ROOT))
                    .collect(Collectors.joining("", prefix, "")), count.applyAsLong(each));
        }
        return status;
    }

    /** The agent is stopped; called on the thread of its {@link Time.Timer}, on which nothing new comes any more. */
    void stop();
}
