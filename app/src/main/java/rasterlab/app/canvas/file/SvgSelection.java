package rasterlab.app.canvas.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;

/** An SVG document for the clipboard: a drawing to those who know SVG, and text to all. */
record SvgSelection(String document) implements Transferable {
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
