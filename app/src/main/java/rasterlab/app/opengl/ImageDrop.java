package rasterlab.app.opengl;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Takes an image file that is dropped on the stage. */
final class ImageDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient Consumer<Path> onImage;

    ImageDrop(Consumer<Path> onImage) {
        this.onImage = onImage;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) return false;
        try {
            var files =
                    (List<?>)
                            support.getTransferable()
                                    .getTransferData(DataFlavor.javaFileListFlavor);
            if (files.isEmpty() || !(files.get(0) instanceof File file)) return false;
            onImage.accept(file.toPath());
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            return false;
        }
    }
}
