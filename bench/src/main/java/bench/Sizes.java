package bench;

import java.io.IOException;
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
        return "`avr-size` of what `gradle firmware` builds. `javino-firmware/README.md` lists what each part takes.";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        Size vehicle = sizeOf("Vehicle");
        rows.add(Row.cited("Vehicle, flash", "%.0f bytes", vehicle.flash, 21300, "the paper's police sketch").goal("smaller"));
        rows.add(Row.cited("Vehicle, static RAM", "%.0f bytes", vehicle.ram, 2908, "the paper's police sketch").goal("smaller"));
        for (String sketch : List.of("Station", "Blink")) {
            Size size = sizeOf(sketch);
            rows.add(Row.of(sketch + ", flash and static RAM", size.flash + " and " + size.ram + " bytes"));
        }
        return rows;
    }

    private record Size(int flash, int ram) { }

    private static Size sizeOf(String sketch) throws IOException, InterruptedException {
        String[] fields = Command.run("avr-size", Machine.firmware(sketch)).get(1).trim().split("\\s+");
        int text = Integer.parseInt(fields[0]);
        int data = Integer.parseInt(fields[1]);
        int bss = Integer.parseInt(fields[2]);
        return new Size(text + data, data + bss);
    }
}
