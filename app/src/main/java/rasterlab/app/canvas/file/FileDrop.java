package rasterlab.app.canvas.file;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.TransferHandler;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;

/** Lets a file be dropped on a component; of several none is taken, and that is told. */
public final class FileDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient Consumer<Path> dropped;
    private final transient Consumer<String> refused;

    /**
     * @param parent of the dialog that tells why nothing was taken
     * @param dropped told the file, on the event thread, after the drop is over
     */
    public FileDrop(Component parent, Language language, Consumer<Path> dropped) {
        this(
                language,
                dropped,
                why ->
                        JOptionPane.showMessageDialog(
                                JOptionPane.getFrameForComponent(parent),
                                why,
                                Texts.of("canvas", language).text("drop.title"),
                                JOptionPane.WARNING_MESSAGE));
    }

    /**
     * @param refused told why nothing was taken, on the event thread, after the drop is over
     */
    FileDrop(Language language, Consumer<Path> dropped, Consumer<String> refused) {
        texts = Texts.of("canvas", language);
        this.dropped = dropped;
        this.refused = refused;
    }

    /**
     * The component around a text that takes files which are dropped there, or pasted without text.
     * Where text comes too, the names of the files are pasted as text.
     */
    public static Optional<FileDrop> around(TransferSupport support) {
        boolean text = support.isDataFlavorSupported(DataFlavor.stringFlavor);
        return support.isDrop() || !text
                ? around(support.getComponent()).filter(drop -> drop.canImport(support))
                : Optional.empty();
    }

    /** The one of the nearest component around that has any. */
    private static Optional<FileDrop> around(Component inner) {
        for (Container each = inner.getParent(); each != null; each = each.getParent())
            if (each instanceof JComponent part
                    && part.getTransferHandler() instanceof FileDrop drop) return Optional.of(drop);
        return Optional.empty();
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
            return files.size() == 1
                    ? taken((File) files.get(0))
                    : refuse(texts.text("drop.several", files.size()));
        } catch (UnsupportedFlavorException | IOException e) {
            return refuse(texts.text("drop.lost", e.getMessage()));
        }
    }

    private boolean taken(File file) {
        try {
            Path path = LastFolderChooser.path(file);
            EventQueue.invokeLater(() -> dropped.accept(path));
            return true;
        } catch (Complaint complaint) {
            return refuse(Complaints.translated(texts.language(), complaint.getMessage()));
        }
    }

    private boolean refuse(String why) {
        EventQueue.invokeLater(() -> refused.accept(why));
        return false;
    }
}
