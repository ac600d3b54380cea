package highway;

import java.util.Optional;

/** The five devices of the scenario (paper, section 5.1): their agent and board have the same name. */
enum Device {
    BUS("ROMA", 33, "#a06a00"),
    POLICE("SUPO", 34, "#1f4fbf"),
    SUPPORT("SUPP", 35, "#96289c"),
    HOSPITAL("SUHO", 36, "#007a80"),
    AMBULANCE("SUAM", 31, "#c02020");

    /** RF address. */
    final String address;
    /** SGR number of the colour in which its lines are printed. */
    final int colour;
    /** The same colour in the picture. */
    final String hue;

    Device(String address, int colour, String hue) {
        this.address = address;
        this.colour = colour;
        this.hue = hue;
    }

    /** The name of its board in the scenario file, of its agent and of its MAS. */
    String id() {
        return name().toLowerCase(java.util.Locale.ROOT);
    }

    /** {@code Bus}, as the paper writes it. */
    String title() {
        return name().charAt(0) + id().substring(1);
    }

    static Optional<Device> withAddress(String address) {
        return java.util.Arrays.stream(values()).filter(device -> device.address.equals(address)).findFirst();
    }

    static Optional<Device> withId(String id) {
        return java.util.Arrays.stream(values()).filter(device -> device.id().equals(id)).findFirst();
    }
}
