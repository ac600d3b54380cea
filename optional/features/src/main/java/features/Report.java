package features;

import io.cucumber.plugin.ConcurrentEventListener;
import io.cucumber.plugin.event.EventPublisher;
import io.cucumber.plugin.event.PickleStepTestStep;
import io.cucumber.plugin.event.Status;
import io.cucumber.plugin.event.TestCaseFinished;
import io.cucumber.plugin.event.TestRunFinished;
import io.cucumber.plugin.event.TestStepFinished;
import io.cucumber.plugin.event.TestStepStarted;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Tells on the terminal how each scenario ends, and of a failure all that its step says. */
public final class Report implements ConcurrentEventListener {

    private final PrintStream out = System.out;
    private final Map<Status, Integer> ended = new TreeMap<>();

    @Override
    public void setEventPublisher(EventPublisher publisher) {
        publisher.registerHandlerFor(TestStepStarted.class, this::started);
        publisher.registerHandlerFor(TestStepFinished.class, this::finished);
        publisher.registerHandlerFor(TestCaseFinished.class, this::finished);
        publisher.registerHandlerFor(TestRunFinished.class, this::finished);
    }

    private static String text(PickleStepTestStep step) {
        String file = step.getUri().getPath().replaceFirst(".*/", "");
        return file + ":" + step.getStep().getLine() + "  " + step.getStep().getKeyword() + step.getStep().getText();
    }

    private void started(TestStepStarted event) {
        if (event.getTestStep() instanceof PickleStepTestStep step) {
            Run.current().ifPresent(run -> run.step = text(step));
        }
    }

    private void finished(TestStepFinished event) {
        Throwable error = event.getResult().getError();
        if (event.getResult().getStatus() == Status.UNDEFINED
                && event.getTestStep() instanceof PickleStepTestStep step) {
            out.println(text(step) + "\n  no step has these words; docs/reference.md in Javino's folder lists all");
        } else if (error instanceof StepFailure) {
            out.println(error.getMessage());
        } else if (error != null && event.getResult().getStatus() != Status.SKIPPED) {
            if (event.getTestStep() instanceof PickleStepTestStep step) {
                out.println(text(step));
            }
            error.printStackTrace(out);
        }
    }

    private void finished(TestCaseFinished event) {
        Status status = event.getResult().getStatus();
        ended.merge(status, 1, Integer::sum);
        out.println(status.name().toLowerCase(Locale.ROOT) + ": " + event.getTestCase().getName());
    }

    private void finished(TestRunFinished event) {
        if (ended.isEmpty()) {
            throw new IllegalStateException("no scenario was run; is there one at that file and line?");
        }
        String all = ended.entrySet().stream()
                .map(each -> each.getValue() + " " + each.getKey().name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(", "));
        out.println("scenarios: " + all);
        if (System.getProperty("javino.port") != null) {
            out.println("not checked on the real board:" + (RealBoard.UNCHECKED.isEmpty() ? " nothing" : ""));
            RealBoard.UNCHECKED.forEach(step -> out.println("  " + step));
            int unchecked = RealBoard.UNCHECKED.size();
            RealBoard.UNCHECKED.clear();
            try {
                Files.writeString(Path.of(System.getProperty("javino.runs", "build/features"), "real-board.txt"),
                        all + "; steps not checked: " + unchecked + "\n");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }
}
