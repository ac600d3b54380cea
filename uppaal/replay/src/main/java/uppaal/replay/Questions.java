package uppaal.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * What came to a board, undamaged, so that it answers or hands it over nearly always: unicasts, and pieces that ask. Of
 * each it is known of what sort it was there.
 */
final class Questions {
    /** A sender waits so long for an answer, in quiet air and in seconds. */
    private static final double PATIENCE = 0.15;

    private final List<Question> open = new ArrayList<>();
    /** Of what sort the last one of a message was. */
    private final Map<Message, String> last = new Recent<>();

    private static final class Question {
        final Message message;
        final String sort;
        final double seconds;
        /** Whether the air was quiet since then for longer than anybody waits for an answer. */
        boolean isLate;

        Question(Message message, String sort, double seconds) {
            this.message = message;
            this.sort = sort;
            this.seconds = seconds;
        }
    }

    void come(Message message, String sort, double seconds) {
        open.add(new Question(message, sort, seconds));
        last.put(message, sort);
    }

    /** One came of which nobody knows whether it was heard: what follows may answer that one. */
    void doubt(Message message) {
        last.remove(message);
    }

    /** Something is heard, or told, at this moment. */
    void pass(double seconds, Ear ear) {
        double quiet = ear.quietSince();
        if (quiet < seconds - PATIENCE && ear.isSure(quiet, seconds)) {
            open.stream().filter(question -> question.seconds < seconds - PATIENCE)
                    .forEach(question -> question.isLate = true);
        }
    }

    /** The board's host has looked. @return by sort, what came before that moment and is not answered; told once */
    Map<String, Message> unanswered(double before) {
        return remove(question -> question.isLate && question.seconds < before);
    }

    /** The board answers that a message is not whole. @return what came before the last question, so likewise */
    Map<String, Message> unanswered(Message message) {
        double lastTime = open.stream().filter(question -> question.message == message)
                .mapToDouble(question -> question.seconds).max().orElse(0);
        return remove(
                question -> question.isLate && question.message == message && question.seconds < lastTime);
    }

    private Map<String, Message> remove(Predicate<Question> which) {
        Map<String, Message> removed = new HashMap<>();
        open.stream().filter(which).forEach(question -> removed.put(question.sort, question.message));
        open.removeIf(which);
        return removed;
    }

    /** The board answers, or hands it over. @return of what sort the last question about it was, if that is known */
    Optional<String> answer(Message message) {
        open.removeIf(question -> question.message == message);
        return Optional.ofNullable(last.remove(message));
    }

    void clear() {
        open.clear();
        last.clear();
    }
}
