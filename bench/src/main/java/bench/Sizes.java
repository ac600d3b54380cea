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
            `avr-size` of what `gradle firmware` builds. Of Vehicle's flash, by `gradle :javino-firmware:sizes`:
            delivery (fragments, acknowledgements, carrier sense) 10.3 kB, radio 8.7, requests and replies 7.2, EEPROM
            2.9, envelopes and nonces 2.8, AES 1.0, frames and addresses 0.9, the sketch 0.3; the Arduino core 2.7, and
            what the linker does not name 2.2. Of the radio, parity takes 3.1 kB of flash and 0.3 of RAM, copies of
            damaged packets 1.0 and 0.9, other mending 2.1; one line of `Config.h` leaves each out. The paper's sketch
            has no acknowledgement, no fragment, no replay memory and no key store; these take the difference in size.
            Of the RAM 4.0 kB are queues: two serial packets of 524 bytes, 640 bytes each for messages received and to
            be sent, two messages in fragments of 534. We tried compiler flags (540 bytes of flash less), a CRC in one
            go, one expanded key instead of two, and radio payloads left in place (77 bytes of RAM less). Without
            `noinline`, which helps the stack, flash would be 86 bytes less. We did not try one buffer for request and
            reply, nor queues that share their memory: they would change what a board can do. With shorter messages it
            fits an Uno.""";
    }

    @Override
    public List<Row> measure() throws Exception {
        List<Row> rows = new ArrayList<>();
        Size vehicle = sizeOf(Machine.firmware("Vehicle"));
        rows.add(Row.cited("Vehicle, flash", "%.0f bytes", vehicle.flash, 21300, "the paper's police sketch")
                .goal("smaller").claim());
        rows.add(Row.cited("Vehicle, static RAM", "%.0f bytes", vehicle.ram, 2908, "the paper's police sketch")
                .goal("smaller").claim());
        for (String sketch : List.of("Station", "Blink")) {
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
