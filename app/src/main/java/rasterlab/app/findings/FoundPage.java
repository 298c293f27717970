package rasterlab.app.findings;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;
import rasterlab.app.hazard.CommandHtml;
import rasterlab.app.hazard.VerdictTable;
import rasterlab.app.language.Texts;
import rasterlab.app.tour.Html;

/** A page of findings as it grows; it prints, and follows the reader's light or dark. */
final class FoundPage {
    /** A space between a number and the word that it counts, where a line must not break. */
    private static final Pattern COUNTED = Pattern.compile("(?<=[\\d%]) (?=\\p{L})|(?<=:) (?=\\d)");

    private final String title;
    private final Texts texts;
    private final String head;
    private final StringBuilder body = new StringBuilder();

    FoundPage(String title, Texts texts) {
        this(title, texts, "");
    }

    /** A page that tells later runs of which run it is. */
    FoundPage(String title, Texts texts, PageOrigin origin) {
        this(title, texts, origin.html());
    }

    private FoundPage(String title, Texts texts, String head) {
        this.title = title;
        this.texts = texts;
        this.head = head;
    }

    FoundPage heading(String words) {
        body.append("<h2>").append(Html.escaped(words)).append("</h2>\n");
        return this;
    }

    FoundPage paragraph(String words) {
        body.append("<p>").append(typed(words)).append("</p>\n");
        return this;
    }

    FoundPage warning(String words) {
        body.append("<p class=\"failure\">").append(typed(words)).append("</p>\n");
        return this;
    }

    FoundPage command(String command) {
        body.append(CommandHtml.of(command));
        return this;
    }

    /** The verdicts on a topic's hazards. */
    FoundPage verdicts(String table) {
        body.append(table);
        return this;
    }

    /**
     * A link with a line about what is there.
     *
     * @param behind may be empty
     */
    FoundPage link(String file, String words, String behind) {
        body.append(
                "<p><a href=\"%s\">%s</a>%s</p>\n"
                        .formatted(
                                file, typed(words), behind.isEmpty() ? "" : ": " + typed(behind)));
        return this;
    }

    /**
     * An entry of the contents.
     *
     * @param file may be empty: there is no such page, and the sentence says why
     */
    FoundPage entry(String file, String name, String sentence) {
        boolean linked = !file.isEmpty();
        String words = typed(name);
        body.append("<section><h3>")
                .append(linked ? "<a href=\"%s\">%s</a>".formatted(file, words) : words)
                .append(linked ? "</h3><p>" : "</h3><p class=\"failure\">")
                .append(typed(sentence))
                .append("</p></section>\n");
        return this;
    }

    FoundPage begin(String kind) {
        body.append("<div class=\"%s\">\n".formatted(kind));
        return this;
    }

    FoundPage end() {
        body.append("</div>\n");
        return this;
    }

    /**
     * A chart that is light or dark as the page is.
     *
     * @param name of its files, without "-dark" and extension
     * @param leads to where a click goes
     */
    FoundPage chart(String name, String caption, String leads) {
        body.append(
                """
                <figure><a href="%s"><picture>
                <source media="(prefers-color-scheme: dark)" srcset="%s-dark.svg">
                <img src="%s.svg" alt="%s"></picture></a>
                <figcaption>%s</figcaption></figure>
                """
                        .formatted(leads, name, name, Html.escaped(caption), typed(caption)));
        return this;
    }

    private static String typed(String words) {
        return COUNTED.matcher(Html.escaped(words)).replaceAll("\u00a0");
    }

    byte[] html() {
        return """
        <!DOCTYPE html>
        <html lang="%s">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        %s<title>%s</title>
        <style>
        %s</style>
        </head>
        <body>
        <header><h1>%s</h1></header>
        <main>
        %s</main>
        </body>
        </html>
        """
                .formatted(
                        texts.locale().getLanguage(),
                        head,
                        Html.escaped(title),
                        Html.style() + style() + CommandHtml.STYLE + VerdictTable.COLORS,
                        Html.escaped(title),
                        body)
                .getBytes(StandardCharsets.UTF_8);
    }

    /** Reads what this page adds to the style of all pages: smaller pictures, and how it prints. */
    private static String style() {
        try (InputStream in = FoundPage.class.getResourceAsStream("findings.css")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("findings.css cannot be read", e);
        }
    }
}
