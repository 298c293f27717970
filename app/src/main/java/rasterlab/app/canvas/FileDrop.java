package rasterlab.app.canvas;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Lets a file be dropped on a component; of several the first counts. */
public final class FileDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient Consumer<Path> dropped;
    private final transient Consumer<Throwable> onFailure;

    /**
     * @param dropped told the file, on the event thread, after the drop is over
     * @param onFailure told why the file could not be had
     */
    public FileDrop(Consumer<Path> dropped, Consumer<Throwable> onFailure) {
        this.dropped = dropped;
        this.onFailure = onFailure;
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
            if (files.isEmpty()) return false;
            Path file = ((File) files.get(0)).toPath();
            EventQueue.invokeLater(() -> dropped.accept(file));
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            onFailure.accept(e);
            return false;
        }
    }
}
