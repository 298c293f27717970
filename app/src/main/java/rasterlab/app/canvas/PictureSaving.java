package rasterlab.app.canvas;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;

/** Asks for a file and saves there what a lab shows once that is chosen. */
final class PictureSaving {
    private final ShownPicture picture;
    private final Component parent;
    private final Language language;
    private final FileWriting writing;

    /**
     * @param parent of the dialogs
     * @param onFailure told what saving threw that no dialog explains
     */
    PictureSaving(
            ShownPicture picture,
            Component parent,
            Language language,
            Consumer<Throwable> onFailure) {
        this.picture = picture;
        this.parent = parent;
        this.language = language;
        writing = new FileWriting(parent, language, onFailure);
    }

    void ask() {
        new PictureChooser(language)
                .toSave(parent, picture.name())
                .ifPresent(file -> picture.whenDrawn().accept(() -> write(file)));
    }

    private void write(Path file) {
        Supplier<byte[]> content = content(PictureForm.of(file));
        writing.write(
                Texts.of("canvas", language).text("picture.title"),
                () -> {
                    WholeFile.write(file, content.get());
                    return file;
                },
                done -> {});
    }

    /** Drawn now, and packed when it is written. */
    private Supplier<byte[]> content(PictureForm form) {
        if (form == PictureForm.SVG) {
            String document = picture.svg().get();
            return () -> document.getBytes(StandardCharsets.UTF_8);
        }
        BufferedImage image = picture.dots().get();
        return () -> PngFile.bytes(image);
    }
}
