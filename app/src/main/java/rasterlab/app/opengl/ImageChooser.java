package rasterlab.app.opengl;

import java.awt.Component;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.filechooser.FileNameExtensionFilter;
import rasterlab.app.canvas.file.LastFolderChooser;
import rasterlab.app.language.Texts;

/** Asks the user for an image file. */
final class ImageChooser {
    private ImageChooser() {}

    /**
     * Returns when the user has chosen; empty where the user chose none.
     *
     * @param above the dialog comes up above it
     */
    static Optional<Path> ask(Component above, Texts texts) {
        var chooser = new LastFolderChooser(texts.language());
        chooser.setName("image.chooser");
        chooser.setDialogTitle(texts.text("open.title"));
        chooser.setFileFilter(
                new FileNameExtensionFilter(
                        texts.text("open.images"), "png", "jpg", "jpeg", "gif", "bmp"));
        return chooser.toOpen(above);
    }
}
