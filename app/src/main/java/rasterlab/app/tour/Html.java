package rasterlab.app.tour;

import java.util.List;

/** The few pieces of HTML that the tour's page is made of. */
final class Html {
    private Html() {}

    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** A table in a frame that scrolls on narrow screens; numbers stand to the right. */
    static String table(List<String> heads, List<List<String>> rows) {
        var html = new StringBuilder("<div class=\"scroll\"><table>\n<thead><tr>");
        for (String head : heads) html.append("<th>").append(escaped(head)).append("</th>");
        html.append("</tr></thead>\n<tbody>\n");
        for (List<String> row : rows) {
            html.append("<tr>");
            for (String cell : row) html.append(cell(cell));
            html.append("</tr>\n");
        }
        return html.append("</tbody></table></div>\n").toString();
    }

    private static String cell(String text) {
        boolean number = text.matches("-?[0-9][0-9 .,/%–e-]*");
        return (number ? "<td class=\"number\">" : "<td>") + escaped(text) + "</td>";
    }
}
