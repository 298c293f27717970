package rasterlab.app.canvas.file;

import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.app.outcome.Complaint;

/** The forms in which a picture is saved, told by the ending of its file in capitals or not. */
public enum PictureForm {
    PNG,
    SVG;

    /** The file ending without its dot. */
    String ending() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The file with this form's ending where it has none. */
    Path named(Path file) {
        String name = file.getFileName().toString();
        return name.lastIndexOf('.') > 0 ? file : file.resolveSibling(name + "." + ending());
    }

    /**
     * @throws Complaint listing the endings, if the file's is none of them
     */
    static PictureForm of(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return Stream.of(values())
                .filter(form -> name.endsWith("." + form.ending()))
                .findFirst()
                .orElseThrow(
                        () ->
                                Complaint.badInput(
                                        file + ": unknown extension; allowed are .png and .svg"));
    }
}
