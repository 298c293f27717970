package rasterlab.app.findings;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import rasterlab.app.language.Texts;
import rasterlab.app.tour.Html;

/** A page of findings as it grows; it prints, and follows the reader's light or dark. */
final class FoundPage {
    private final String title;
    private final Texts texts;
    private final StringBuilder body = new StringBuilder();

    FoundPage(String title, Texts texts) {
        this.title = title;
        this.texts = texts;
    }

    FoundPage heading(String words) {
        body.append("<h2>").append(Html.escaped(words)).append("</h2>\n");
        return this;
    }

    FoundPage paragraph(String words) {
        body.append("<p>").append(Html.escaped(words)).append("</p>\n");
        return this;
    }

    FoundPage warning(String words) {
        body.append("<p class=\"failure\">").append(Html.escaped(words)).append("</p>\n");
        return this;
    }

    FoundPage command(String command) {
        body.append("<pre>").append(Html.escaped(command)).append("</pre>\n");
        return this;
    }

    FoundPage table(List<String> heads, List<List<String>> rows) {
        body.append(Html.table(heads, rows));
        return this;
    }

    FoundPage link(String file, String words, String behind) {
        body.append(
                "<p><a href=\"%s\">%s</a> %s</p>\n"
                        .formatted(file, Html.escaped(words), Html.escaped(behind)));
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
                        .formatted(
                                leads, name, name, Html.escaped(caption), Html.escaped(caption)));
        return this;
    }

    byte[] html() {
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
        <header><h1>%s</h1></header>
        <main>
        %s</main>
        </body>
        </html>
        """
                .formatted(
                        texts.locale().getLanguage(),
                        Html.escaped(title),
                        Html.style() + style(),
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
