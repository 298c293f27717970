package rasterlab.app.canvas.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Files as a file manager gives them.
 *
 * @param failure what getting them throws
 */
public record DroppedFiles(List<File> files, Optional<IOException> failure)
        implements Transferable {
    public static DroppedFiles of(File... files) {
        return new DroppedFiles(List.of(files), Optional.empty());
    }

    @Override
    public DataFlavor[] getTransferDataFlavors() {
        return new DataFlavor[] {DataFlavor.javaFileListFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
        return flavor.equals(DataFlavor.javaFileListFlavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) throws IOException {
        if (failure.isPresent()) throw failure.get();
        return files;
    }
}
