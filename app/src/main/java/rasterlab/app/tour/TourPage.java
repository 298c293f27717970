package rasterlab.app.tour;

import java.awt.image.BufferedImage;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.PngFile;
import rasterlab.app.outcome.WholeFile;

/** The page as it grows, and the folder its pictures go to. */
final class TourPage {
    static final String PICTURES = "pictures";

    private final Path folder;
    private final Texts texts;
    private final PrintStream progress;
    private final StringBuilder contents = new StringBuilder();
    private final StringBuilder body = new StringBuilder();

    TourPage(Path folder, Language language, PrintStream progress) {
        this.folder = folder;
        this.texts = Texts.of("tour", language);
        this.progress = progress;
    }

    Texts texts() {
        return texts;
    }

    /** Tells whoever waits what is being done. */
    void say(String step) {
        progress.println(step);
    }

    /** Begins a section with its title and introduction, by their key. */
    void begin(String key) {
        String title = Html.escaped(texts.text(key + ".title"));
        say(texts.text(key + ".title"));
        contents.append("<a href=\"#%s\">%s</a>\n".formatted(key, title));
        body.append("<h2 id=\"%s\">%s</h2>\n".formatted(key, title));
        paragraph(texts.text(key + ".introduction"));
    }

    void heading(String title) {
        body.append("<h3>").append(Html.escaped(title)).append("</h3>\n");
    }

    void paragraph(String text) {
        body.append("<p>").append(Html.escaped(text)).append("</p>\n");
    }

    /** Writes text as it stands, in fixed-width letters. */
    void preformatted(String text) {
        body.append("<pre>").append(Html.escaped(text)).append("</pre>\n");
    }

    /** Says in the section's place that it could not be made, and why. */
    void fail(Throwable e) {
        String english = e.getMessage() == null ? e.toString() : e.getMessage();
        String reason = Complaints.translated(texts.language(), english);
        say(texts.text("failed", reason));
        body.append("<p class=\"failure\">")
                .append(Html.escaped(texts.text("failed", reason)))
                .append("</p>\n");
    }

    /** Writes a table of words and numbers; cells that are numbers stand to the right. */
    void table(List<String> heads, List<List<String>> rows) {
        body.append(Html.table(heads, rows));
    }

    /**
     * Writes the same.
     *
     * @param heads with {@code |} between them, as they stand in the texts
     */
    void table(String heads, List<List<String>> rows) {
        table(List.of(heads.split("\\|")), rows);
    }

    /** Shows large pictures, at most two side by side, each with its caption. */
    void gallery(List<CaptionedPicture> figures) {
        append("gallery", figures);
    }

    /** Pictures to compare, four side by side where there is room. */
    void smallGallery(List<CaptionedPicture> figures) {
        append("small gallery", figures);
    }

    /** Shows one picture in its own size. */
    void large(CaptionedPicture figure) {
        append("large gallery", List.of(figure));
    }

    private void append(String kind, List<CaptionedPicture> figures) {
        body.append("<div class=\"%s\">\n".formatted(kind));
        for (CaptionedPicture figure : figures) body.append(figure.html());
        body.append("</div>\n");
    }

    /**
     * Writes a picture and describes it.
     *
     * @param name of the file, without folder and extension
     */
    CaptionedPicture picture(String name, BufferedImage image, String caption) {
        return picture(name, PngFile.bytes(image), caption);
    }

    /** Writes a picture that is PNG already and describes it. */
    CaptionedPicture picture(String name, byte[] png, String caption) {
        WholeFile.write(folder.resolve(PICTURES).resolve(name + ".png"), png);
        return new CaptionedPicture(PICTURES + "/" + name + ".png", caption);
    }

    /**
     * A picture with a caption.
     *
     * @param file from the page's folder
     */
    record CaptionedPicture(String file, String caption) {
        private String html() {
            String words = Html.escaped(caption);
            return """
            <figure><a href="%s"><img src="%s" alt="%s"></a>
            <figcaption>%s</figcaption></figure>
            """
                    .formatted(file, file, words, words);
        }
    }

    String html() {
        return """
        <!DOCTYPE html>
        <html lang="%s">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <title>%s</title>
        <style>
        %s</style>
        </head>
        <body>
        <header><h1>%s</h1><p>%s</p></header>
        <nav>
        %s</nav>
        <main>
        %s</main>
        <footer><p>%s</p></footer>
        </body>
        </html>
        """
                .formatted(
                        texts.locale().getLanguage(),
                        Html.escaped(texts.text("title")),
                        Html.style(),
                        Html.escaped(texts.text("title")),
                        Html.escaped(texts.text("introduction")),
                        contents,
                        body,
                        Html.escaped(texts.text("footer", machine())));
    }

    private static String machine() {
        return "%s %s, %s, Java %s"
                .formatted(
                        System.getProperty("os.name"),
                        System.getProperty("os.version"),
                        System.getProperty("os.arch"),
                        System.getProperty("java.version"));
    }
}
