package rasterlab.app.tour;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;

/** The few pieces of HTML that the pages of the tour and of the findings are made of. */
public final class Html {
    /** A number, a share, a range, a fraction or a dash where there is none. */
    private static final Pattern NUMBERS =
            Pattern.compile("–|[−-]?[0-9][0-9 \u00a0.,/%–·⁻⁰¹²³⁴-⁹]*");

    private Html() {}

    /** Reads the style sheet that all pages share. */
    public static String style() {
        try (InputStream in = Html.class.getResourceAsStream("page.css")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("page.css cannot be read", e);
        }
    }

    public static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /**
     * A table in a frame that scrolls on narrow screens; columns of numbers stand to the right. The
     * last cell of a row that is too short, such as a sentence, reaches to the table's end.
     */
    public static String table(List<String> heads, List<List<String>> rows) {
        var html = new StringBuilder("<div class=\"scroll\"><table>\n<thead><tr>");
        for (int column = 0; column < heads.size(); column++)
            html.append(cell("th", heads.get(column), attribute(rows, column)));
        html.append("</tr></thead>\n<tbody>\n");
        for (List<String> row : rows) {
            html.append("<tr>");
            int last = row.size() - 1;
            for (int column = 0; column < last; column++)
                html.append(cell("td", row.get(column), attribute(rows, column)));
            int columns = heads.size() - last;
            html.append(
                    cell(
                            "td",
                            row.get(last),
                            columns > 1 ? " colspan=\"" + columns + "\"" : attribute(rows, last)));
            html.append("</tr>\n");
        }
        return html.append("</tbody></table></div>\n").toString();
    }

    /**
     * The attribute of the cells of a column of numbers; sentences that reach over several do not
     * count.
     */
    private static String attribute(List<List<String>> rows, int column) {
        int columns = rows.stream().mapToInt(List::size).max().orElse(0);
        boolean numbers =
                rows.stream()
                        .filter(row -> row.size() == columns || column < row.size() - 1)
                        .allMatch(row -> NUMBERS.matcher(row.get(column)).matches());
        return numbers ? " class=\"number\"" : "";
    }

    private static String cell(String tag, String text, String attribute) {
        return "<" + tag + attribute + ">" + escaped(text) + "</" + tag + ">";
    }
}
