package uppaal.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;

/**
 * The numbers that the model takes from the firmware's sources.
 *
 * @param folder {@code javino-firmware/src}
 */
record Firmware(Path folder) {
    private static final int BIT_RATE = 2000;

    /**
     * What the model's constants must be, by name.
     *
     * @param unit slots a unit of time
     */
    Map<String, Integer> constants(int unit) {
        int span = number("delivery/Backoff.cpp", "LEAST_WINDOW = (\\d+);");
        int doublings = number("delivery/Backoff.cpp", "LAST_DOUBLING = (\\d+);");
        int slotBits = number("radio/AskRadio.cpp", "SLOT_BITS = (\\d+);");
        int patience = number("delivery/Courier.cpp", "PATIENCE_MILLIS = (\\d+);") * BIT_RATE / (1000 * slotBits);
        Map<String, Integer> constants = new LinkedHashMap<>();
        constants.put("ATTEMPTS", number("delivery/Courier.cpp", "MAX_ATTEMPTS = (\\d+);"));
        constants.put("PATIENCE", patience / unit);
        constants.put("FIRST_SLOTS", up(number("delivery/Backoff.cpp", "FIRST_SLOTS = (\\d+);"), unit));
        constants.put("FIRST_SPAN", up(span, unit));
        constants.put("LAST_SPAN", up(span << doublings, unit));
        constants.put("SENDS", number("Config.h", "define JAVINO_MULTICAST_SENDS (\\d+)"));
        return constants;
    }

    private static int up(int slots, int unit) {
        return (slots + unit - 1) / unit;
    }

    private int number(String file, String pattern) {
        try {
            Matcher matcher = Pattern.compile(pattern).matcher(Files.readString(folder.resolve(file)));
            if (matcher.find()) {
                return Integer.parseInt(matcher.group(1));
            }
            throw new ModelException(file, "there is no '" + pattern + "', which the model of delivery needs");
        } catch (IOException problem) {
            throw ModelException.unreadable(folder.resolve(file), problem);
        }
    }
}
