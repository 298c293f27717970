package rasterlab.app.canvas;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.InputEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import javax.swing.text.JTextComponent;

/** Text goes where it went before; a file that is dropped, to what takes files around the field. */
final class FieldDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient TransferHandler text;

    private FieldDrop(TransferHandler text) {
        this.text = text;
    }

    static void on(JTextComponent field) {
        field.setTransferHandler(new FieldDrop(field.getTransferHandler()));
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return files(support).isPresent() || text.canImport(support);
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<FileDrop> files = files(support);
        return files.isPresent() ? files.get().importData(support) : text.importData(support);
    }

    /** Empty for text: also where a file is pasted by its name. */
    private Optional<FileDrop> files(TransferSupport support) {
        boolean named = support.isDataFlavorSupported(DataFlavor.stringFlavor);
        if (!support.isDrop() && named) return Optional.empty();
        return FileDrop.around(support.getComponent()).filter(drop -> drop.canImport(support));
    }

    @Override
    public int getSourceActions(JComponent field) {
        return text.getSourceActions(field);
    }

    @Override
    public void exportAsDrag(JComponent field, InputEvent e, int action) {
        text.exportAsDrag(field, e, action);
    }

    @Override
    public void exportToClipboard(JComponent field, Clipboard clipboard, int action) {
        text.exportToClipboard(field, clipboard, action);
    }
}
