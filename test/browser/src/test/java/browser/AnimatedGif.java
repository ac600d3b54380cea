package browser;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/** A moving picture that begins again at its end. A frame has only those pixels that have changed. */
final class AnimatedGif {

    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    /** The last index of the palette. */
    private static final int UNCHANGED = 255;
    /** How near to each other, in sums of differences of red, green and blue, two colours of the palette may be. */
    private static final int NEAR = 16;

    private final List<BufferedImage> frames = new ArrayList<>();
    private final List<Integer> hundredths = new ArrayList<>();

    /** Adds an opaque frame, as large as all others, that is seen for so many milliseconds. */
    void add(BufferedImage frame, long millis) {
        frames.add(frame);
        hundredths.add(Math.toIntExact(Math.max(2, Math.round(millis / 10.0))));
    }

    void write(File file) throws IOException {
        int[] palette = palette();
        Map<Integer, Byte> nearest = new HashMap<>();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        file.delete();
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file)) {
            writer.setOutput(out);
            writer.prepareWriteSequence(null);
            byte[] shown = null;
            for (int i = 0; i < frames.size(); i++) {
                byte[] pixels = indexes(frames.get(i), palette, nearest);
                BufferedImage change = change(shown, pixels, frames.get(i), palette);
                writer.writeToSequence(new IIOImage(change, null, metadata(writer, change, hundredths.get(i))), null);
                shown = pixels;
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    /** The most frequent colours, none near another. */
    private int[] palette() {
        Map<Integer, Integer> counts = new HashMap<>();
        for (BufferedImage frame : frames) {
            for (int colour : colours(frame)) {
                counts.merge(colour & 0xffffff, 1, Integer::sum);
            }
        }
        List<Integer> chosen = new ArrayList<>();
        counts.entrySet().stream().sorted(Map.Entry.<Integer, Integer>comparingByValue().reversed())
                .map(Map.Entry::getKey).forEach(colour -> {
                    if (chosen.size() < UNCHANGED
                            && chosen.stream().noneMatch(other -> distance(other, colour) < NEAR)) {
                        chosen.add(colour);
                    }
                });
        int[] palette = new int[UNCHANGED + 1];
        for (int i = 0; i < chosen.size(); i++) {
            palette[i] = chosen.get(i);
        }
        return palette;
    }

    private static byte[] indexes(BufferedImage frame, int[] palette, Map<Integer, Byte> nearest) {
        int[] colours = colours(frame);
        byte[] indexes = new byte[colours.length];
        for (int i = 0; i < colours.length; i++) {
            indexes[i] = nearest.computeIfAbsent(colours[i] & 0xffffff, colour -> {
                int best = 0;
                for (int each = 1; each < UNCHANGED; each++) {
                    best = distance(palette[each], colour) < distance(palette[best], colour) ? each : best;
                }
                return (byte) best;
            });
        }
        return indexes;
    }

    private static BufferedImage change(byte[] shown, byte[] pixels, BufferedImage frame, int[] palette) {
        byte[] change = pixels.clone();
        for (int i = 0; shown != null && i < change.length; i++) {
            if (shown[i] == change[i]) {
                change[i] = (byte) UNCHANGED;
            }
        }
        BufferedImage image = new BufferedImage(frame.getWidth(), frame.getHeight(), BufferedImage.TYPE_BYTE_INDEXED,
                new IndexColorModel(8, palette.length, palette, 0, false, UNCHANGED,
                        DataBuffer.TYPE_BYTE));
        image.getRaster().setDataElements(0, 0, frame.getWidth(), frame.getHeight(), change);
        return image;
    }

    private static IIOMetadata metadata(ImageWriter writer, BufferedImage image, int hundredths) throws IOException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), null);
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("transparentColorIndex", Integer.toString(UNCHANGED));
        control.setAttribute("delayTime", Integer.toString(hundredths));
        root.appendChild(control);
        IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
        IIOMetadataNode forever = new IIOMetadataNode("ApplicationExtension");
        forever.setAttribute("applicationID", "NETSCAPE");
        forever.setAttribute("authenticationCode", "2.0");
        forever.setUserObject(new byte[] {1, 0, 0});
        extensions.appendChild(forever);
        root.appendChild(extensions);
        metadata.mergeTree(FORMAT, root);
        return metadata;
    }

    private static int[] colours(BufferedImage frame) {
        return frame.getRGB(0, 0, frame.getWidth(), frame.getHeight(), null, 0, frame.getWidth());
    }

    private static int distance(int a, int b) {
        return Math.abs((a >> 16 & 255) - (b >> 16 & 255)) + Math.abs((a >> 8 & 255) - (b >> 8 & 255))
                + Math.abs((a & 255) - (b & 255));
    }
}
