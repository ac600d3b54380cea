package lockstep;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Map;

/** Makes a class call others than it was compiled for. */
final class ClassPatch {

    private static final int TEXT = 1;

    private ClassPatch() {}

    /** The bytes of a class, with other names of classes in the place of some, wherever its constants have them. */
    static byte[] replace(byte[] bytes, Map<String, String> texts) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        ByteArrayOutputStream patched = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(patched);
        out.write(in.readNBytes(8));
        int count = in.readUnsignedShort();
        out.writeShort(count);
        for (int i = 1; i < count; i++) {
            int tag = in.readUnsignedByte();
            out.writeByte(tag);
            switch (tag) {
                case TEXT -> {
                    String constant = in.readUTF();
                    for (Map.Entry<String, String> text : texts.entrySet()) {
                        constant = constant.replace(text.getKey(), text.getValue());
                    }
                    out.writeUTF(constant);
                }
                case 5, 6 -> {  // Two places each.
                    out.write(in.readNBytes(8));
                    i++;
                }
                case 7, 8, 16, 19, 20 -> out.write(in.readNBytes(2));
                case 15 -> out.write(in.readNBytes(3));
                default -> out.write(in.readNBytes(4));
            }
        }
        out.write(in.readAllBytes());
        return patched.toByteArray();
    }
}
