package rasterlab.app.exercise;

import java.awt.Image;
import java.net.MalformedURLException;
import java.net.URL;
import java.util.Hashtable;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.commonmark.ext.gfm.tables.TableBlock;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.AttributeProvider;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlRenderer;

/**
 * An exercise's Markdown as HTML that Swing shows. A block of rows made of {@code #} and {@code .}
 * becomes a picture of pixels.
 */
final class Statement {
    private static final List<TablesExtension> EXTENSIONS =
            List.of((TablesExtension) TablesExtension.create());

    private final Hashtable<URL, Image> pictures = new Hashtable<>();
    private final String html;

    /**
     * @param picture draws rows of pixels
     */
    Statement(String markdown, Function<List<String>, Image> picture) {
        html =
                HtmlRenderer.builder()
                        .extensions(EXTENSIONS)
                        .escapeHtml(true)
                        .sanitizeUrls(true)
                        .attributeProviderFactory(context -> new TableLines())
                        .nodeRendererFactory(context -> new Blocks(context, picture))
                        .build()
                        .render(Parser.builder().extensions(EXTENSIONS).build().parse(markdown));
    }

    String html() {
        return html;
    }

    /** What the pictures' addresses in the HTML stand for. */
    Hashtable<URL, Image> pictures() {
        return pictures;
    }

    /** The rows of a picture of pixels; empty where the text is none. */
    static List<String> pixels(String text) {
        List<String> rows = text.strip().lines().map(String::strip).toList();
        boolean drawn =
                rows.size() > 1
                        && rows.stream().allMatch(row -> row.matches("[#.]+"))
                        && rows.stream().map(String::length).distinct().count() == 1;
        return drawn ? rows : List.of();
    }

    private static final class TableLines implements AttributeProvider {
        @Override
        public void setAttributes(Node node, String tag, Map<String, String> attributes) {
            if (node instanceof TableBlock) {
                attributes.put("cellspacing", "0");
                attributes.put("cellpadding", "5");
            }
        }
    }

    private final class Blocks implements NodeRenderer {
        private final HtmlNodeRendererContext context;
        private final Function<List<String>, Image> picture;

        Blocks(HtmlNodeRendererContext context, Function<List<String>, Image> picture) {
            this.context = context;
            this.picture = picture;
        }

        @Override
        public Set<Class<? extends Node>> getNodeTypes() {
            return Set.of(IndentedCodeBlock.class);
        }

        @Override
        public void render(Node node) {
            String text = ((IndentedCodeBlock) node).getLiteral();
            List<String> rows = pixels(text);
            var out = context.getWriter();
            out.line();
            if (rows.isEmpty()) {
                out.tag("pre");
                out.text(text.stripTrailing());
                out.tag("/pre");
            } else {
                out.tag("p");
                out.tag("img", Map.of("src", address(rows), "alt", String.join(" ", rows)), true);
                out.tag("/p");
            }
            out.line();
        }

        private String address(List<String> rows) {
            try {
                URL address = new URL("file:/pixels/" + pictures.size());
                pictures.put(address, picture.apply(rows));
                return address.toString();
            } catch (MalformedURLException e) {
                throw new AssertionError("the scheme is known to every JDK", e);
            }
        }
    }
}
