package bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Flash and static RAM of the sketches. */
final class Sizes implements Subject {

    @Override
    public String name() {
        return "sizes";
    }

    @Override
    public String method() {
        return """
            `avr-size` of what `gradle firmware` builds, with the Arduino IDE's flags; `gradle :javino-firmware:sizes`
            prints what each folder of the library takes of Vehicle. The paper's sketch has no acknowledgement, no
            fragment, no replay memory and no key store; these take the difference in size. A sketch without a radio
            (Blink) has none of them either. With `-DJAVINO_SMALL` a Mega has the small profile, as an Uno.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        Size vehicle = sizeOf(Machine.firmware("Vehicle"));
        rows.add(Row.cited("Vehicle, flash", "%.0f bytes", vehicle.flash, 21300, "the paper's police sketch")
                .goal("smaller").claim());
        rows.add(Row.cited("Vehicle, static RAM", "%.0f bytes", vehicle.ram, 2908, "the paper's police sketch")
                .goal("smaller").claim());
        for (String sketch : List.of("RadioBlink", "Blink")) {
            rows.add(row(sketch, sizeOf(Machine.firmware(sketch))));
            rows.add(row(sketch + " on an Uno", sizeOf(Machine.unoFirmware(sketch))));
        }
        return rows;
    }

    private record Size(int flash, int ram) {}

    private static Row row(String title, Size size) {
        return Row.of(title + ", flash and static RAM", size.flash + " and " + size.ram + " bytes");
    }

    private static Size sizeOf(Path program) throws IOException, InterruptedException {
        String[] fields = Command.run("avr-size", program).get(1).trim().split("\\s+");
        int text = Integer.parseInt(fields[0]);
        int data = Integer.parseInt(fields[1]);
        int bss = Integer.parseInt(fields[2]);
        return new Size(text + data, data + bss);
    }
}
