package rasterlab.app.tour;

import java.util.List;
import java.util.regex.Pattern;

/** The few pieces of HTML that the tour's page is made of. */
final class Html {
    /** A number, a share, a range or a fraction. */
    private static final Pattern NUMBERS = Pattern.compile("-?[0-9][0-9 .,/%–e-]*");

    private Html() {}

    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A table in a frame that scrolls on narrow screens; columns of numbers stand to the right. */
    static String table(List<String> heads, List<List<String>> rows) {
        var html = new StringBuilder("<div class=\"scroll\"><table>\n<thead><tr>");
        for (int column = 0; column < heads.size(); column++)
            html.append(cell("th", heads.get(column), numeric(rows, column)));
        html.append("</tr></thead>\n<tbody>\n");
        for (List<String> row : rows) {
            html.append("<tr>");
            for (int column = 0; column < row.size(); column++)
                html.append(cell("td", row.get(column), numeric(rows, column)));
            html.append("</tr>\n");
        }
        return html.append("</tbody></table></div>\n").toString();
    }

    private static boolean numeric(List<List<String>> rows, int column) {
        return rows.stream().allMatch(row -> NUMBERS.matcher(row.get(column)).matches());
    }

    private static String cell(String tag, String text, boolean number) {
        String start = number ? "<" + tag + " class=\"number\">" : "<" + tag + ">";
        return start + escaped(text) + "</" + tag + ">";
    }
}
