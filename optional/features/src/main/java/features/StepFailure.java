package features;

/** What a step expected and did not see. Its message says all; no frames of Java's stack come with it. */
final class StepFailure extends AssertionError {

    private static final long serialVersionUID = 1;

    StepFailure(String message) {
        super(message);
    }

    @Override
    public synchronized Throwable fillInStackTrace() {
        return this;
    }
}
