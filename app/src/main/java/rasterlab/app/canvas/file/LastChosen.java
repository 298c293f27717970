package rasterlab.app.canvas.file;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.UIManager;

/**
 * Where a file was chosen last, and the form of the picture that was saved last: every dialog for
 * files begins with these. On the event thread.
 *
 * @param folder empty before a file is chosen
 */
public record LastChosen(Optional<Path> folder, PictureForm form) {
    /** The choice of a first run. */
    public static final LastChosen NONE = new LastChosen(Optional.empty(), PictureForm.PNG);

    private static final String KEY = "Rasterlab.lastChosen";

    public static LastChosen now() {
        return UIManager.get(KEY) instanceof LastChosen last ? last : NONE;
    }

    /** The next dialog begins with this. */
    public void remember() {
        UIManager.put(KEY, this);
    }

    LastChosen in(Path other) {
        return new LastChosen(Optional.of(other), form);
    }

    LastChosen as(PictureForm other) {
        return new LastChosen(folder, other);
    }

    /** The folder, unless it has gone. */
    Optional<File> standing() {
        return folder.map(Path::toFile).filter(File::isDirectory);
    }
}
