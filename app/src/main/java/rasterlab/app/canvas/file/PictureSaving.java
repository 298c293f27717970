package rasterlab.app.canvas.file;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;

/** Asks for a file and saves there what a lab shows once that is chosen. */
public final class PictureSaving {
    private final ShownPicture picture;
    private final Component parent;
    private final Language language;
    private final FileWriting writing;
    private final Consumer<Path> onSaved;

    /**
     * @param parent of the dialogs
     * @param onSaved told on the event thread which file is written
     * @param onFailure told what saving threw that no dialog explains
     */
    public PictureSaving(
            ShownPicture picture,
            Component parent,
            Language language,
            Consumer<Path> onSaved,
            Consumer<Throwable> onFailure) {
        this.picture = picture;
        this.parent = parent;
        this.language = language;
        this.onSaved = onSaved;
        writing = new FileWriting(parent, language, onFailure);
    }

    public void ask() {
        new PictureChooser(language).toSave(parent, picture.name()).ifPresent(this::prepare);
    }

    /** The first drawing loads much, for which the window would not answer. */
    private void prepare(Path file) {
        PictureForm form = PictureForm.of(file);
        inBackground(
                () -> {
                    if (form == PictureForm.SVG) SvgPicture.prepare();
                    return file;
                },
                ready -> picture.whenDrawn().accept(() -> write(ready, content(form))));
    }

    private void write(Path file, Supplier<byte[]> content) {
        inBackground(
                () -> {
                    WholeFile.write(file, content.get());
                    return file;
                },
                onSaved);
    }

    private void inBackground(Callable<Path> work, Consumer<Path> then) {
        writing.write(Texts.of("canvas", language).text("picture.title"), work, then);
    }

    /** The file's content, drawn now, and packed when it is written. */
    private Supplier<byte[]> content(PictureForm form) {
        if (form == PictureForm.SVG) {
            SvgDrawing drawing = picture.svg().get();
            return () -> drawing.document().getBytes(StandardCharsets.UTF_8);
        }
        BufferedImage image = picture.dots().get();
        return () -> PngFile.bytes(image);
    }
}
