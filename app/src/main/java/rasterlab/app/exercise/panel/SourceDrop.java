package rasterlab.app.exercise.panel;

import java.util.Optional;
import org.fife.ui.rtextarea.RTATextTransferHandler;
import rasterlab.app.canvas.file.FileDrop;

/** Takes text; a file that is dropped goes to what takes files around the editor. */
final class SourceDrop extends RTATextTransferHandler {
    private static final long serialVersionUID = 1L;

    @Override
    public boolean canImport(TransferSupport support) {
        return FileDrop.around(support).isPresent() || super.canImport(support);
    }

    @Override
    public boolean importData(TransferSupport support) {
        Optional<FileDrop> files = FileDrop.around(support);
        return files.isPresent() ? files.get().importData(support) : super.importData(support);
    }
}
