package rasterlab.app.canvas.widget;

import java.awt.datatransfer.Clipboard;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import javax.swing.text.JTextComponent;
import rasterlab.app.canvas.file.FileDrop;

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
        return FileDrop.around(support).isPresent() || text.canImport(support);
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<FileDrop> files = FileDrop.around(support);
        return files.isPresent() ? files.get().importData(support) : text.importData(support);
    }

    @Override
    public int getSourceActions(JComponent field) {
        return text.getSourceActions(field);
    }

    @Override
    public void exportToClipboard(JComponent field, Clipboard clipboard, int action) {
        text.exportToClipboard(field, clipboard, action);
    }
}
