package harness;

import java.util.Map;
import trace.TraceEvent;

/** A board with an AVR, which our emulator runs. */
public record AvrBoard(Emulator emulator, String name) implements SketchBoard {

    /** The scenario's key by which awaitLit() sees the lamp. */
    public static final Map<String, Object> LAMP = Map.of("pin", 13, "name", "lamp");

    @Override
    public String port() {
        return emulator.port(name);
    }

    @Override
    public void analog(String pin, int value) {
        emulator.command(Map.of("do", "sensor", "board", name, "pin", pin, "value", value));
    }

    @Override
    public void awaitLit(int times) throws InterruptedException {
        emulator.await("light", times, this::isLit);
    }

    private boolean isLit(TraceEvent event) {
        return event.is("pin", name) && event.text("name").equals("lamp") && event.number("level") == 1;
    }

    @Override
    public void reset() {
        emulator.command(Map.of("do", "reset", "board", name));
    }

    @Override
    public void close() {
        emulator.close();
    }
}
