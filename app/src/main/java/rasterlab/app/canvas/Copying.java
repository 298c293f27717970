package rasterlab.app.canvas;

import java.awt.Image;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/** Puts pictures and commands on the system's clipboard. */
public final class Copying {
    private Copying() {}

    /**
     * @param onFailure told when the system has no clipboard or another program holds it
     */
    public static void text(String text, Consumer<Throwable> onFailure) {
        put(new StringSelection(text), onFailure);
    }

    /** Copies a picture, dot by dot. */
    public static void picture(BufferedImage picture, Consumer<Throwable> onFailure) {
        put(new PictureSelection(picture), onFailure);
    }

    /** Copies an SVG document, as a drawing to those who know SVG and as text to all. */
    public static void svg(String document, Consumer<Throwable> onFailure) {
        put(new SvgSelection(document), onFailure);
    }

    private static void put(Transferable content, Consumer<Throwable> onFailure) {
        try {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(content, null);
        } catch (IllegalStateException | UnsupportedOperationException e) {
            onFailure.accept(e);
        }
    }

    private record PictureSelection(Image picture) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.imageFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return DataFlavor.imageFlavor.equals(flavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
            if (!isDataFlavorSupported(flavor)) throw new UnsupportedFlavorException(flavor);
            return picture;
        }
    }

    private record SvgSelection(String document) implements Transferable {
        private static final DataFlavor SVG =
                new DataFlavor("image/svg+xml;class=java.io.InputStream", "SVG");

        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {SVG, DataFlavor.stringFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return SVG.equals(flavor) || DataFlavor.stringFlavor.equals(flavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
            if (DataFlavor.stringFlavor.equals(flavor)) return document;
            if (!SVG.equals(flavor)) throw new UnsupportedFlavorException(flavor);
            return new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8));
        }
    }
}
