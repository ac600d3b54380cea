package campaign;

/** Keys with strangers, by emulated boards. */
public final class Strangers implements Campaign {

    @Override
    public String name() {
        return "strangers";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        new MeetingsOnBoards(settings, report).run();
    }
}
