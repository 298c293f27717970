package rasterlab.app.exercise.statement;

import java.awt.Image;
import java.net.MalformedURLException;
import java.net.URL;
import java.util.Hashtable;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TableBlock;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.AttributeProvider;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlRenderer;
import rasterlab.exercises.formula.FormulaMarkdown;
import rasterlab.exercises.formula.TexFormula;
import rasterlab.exercises.formula.Typeset;

/**
 * An exercise's Markdown as HTML that Swing shows, with its pictures. A block of rows made of
 * {@code #} and {@code .} becomes a picture of pixels.
 */
final class Statement {
    private static final List<Extension> EXTENSIONS =
            List.of(TablesExtension.create(), new FormulaMarkdown());

    private final Hashtable<URL, Image> pictures = new Hashtable<>();
    private final StatementFormulas formulas;
    private final String html;

    /** The component that draws the pictures. */
    interface StatementPainter {
        /** Rows of pixels: {@code #} lit, {@code .} not. */
        Image pixels(List<String> rows);

        /** A picture of the exercise by its name; empty where it cannot be shown. */
        Optional<Image> picture(String name);

        /** The formula as it is set; empty as long as it is not. */
        Optional<Typeset> formula(TexFormula formula);
    }

    /**
     * @param language of notes about formulas, such as "ru"
     */
    Statement(String markdown, String language, StatementPainter painter) {
        formulas = new StatementFormulas(painter::formula, language);
        html =
                HtmlRenderer.builder()
                        .extensions(EXTENSIONS)
                        .escapeHtml(true)
                        .sanitizeUrls(true)
                        .attributeProviderFactory(context -> new TableLines())
                        .nodeRendererFactory(context -> new Drawn(context, painter))
                        .nodeRendererFactory(formulas::renderer)
                        .build()
                        .render(Parser.builder().extensions(EXTENSIONS).build().parse(markdown));
    }

    String html() {
        return html;
    }

    /** The pictures that the addresses in the HTML stand for. */
    Hashtable<URL, Image> pictures() {
        return pictures;
    }

    StatementFormulas formulas() {
        return formulas;
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

    private final class Drawn implements NodeRenderer {
        private final HtmlNodeRendererContext context;
        private final StatementPainter painter;

        Drawn(HtmlNodeRendererContext context, StatementPainter painter) {
            this.context = context;
            this.painter = painter;
        }

        @Override
        public Set<Class<? extends Node>> getNodeTypes() {
            return Set.of(IndentedCodeBlock.class, org.commonmark.node.Image.class);
        }

        @Override
        public void render(Node node) {
            if (node instanceof IndentedCodeBlock block) code(block.getLiteral());
            else picture((org.commonmark.node.Image) node);
        }

        private void code(String text) {
            List<String> rows = pixels(text);
            var out = context.getWriter();
            out.line();
            if (rows.isEmpty()) {
                out.tag("pre");
                out.text(text.stripTrailing());
                out.tag("/pre");
            } else {
                out.tag("p");
                put(painter.pixels(rows), String.join(" ", rows));
                out.tag("/p");
            }
            out.line();
        }

        /** A picture that cannot be shown gives way to its words. */
        private void picture(org.commonmark.node.Image node) {
            String words = words(node);
            painter.picture(node.getDestination())
                    .ifPresentOrElse(
                            image -> put(image, words),
                            () -> {
                                context.getWriter().tag("i");
                                context.getWriter().text("[" + words + "]");
                                context.getWriter().tag("/i");
                            });
        }

        private static String words(Node node) {
            var words = new StringBuilder();
            node.accept(
                    new AbstractVisitor() {
                        @Override
                        public void visit(Text text) {
                            words.append(text.getLiteral());
                        }
                    });
            return words.toString();
        }

        private void put(Image image, String words) {
            context.getWriter().tag("img", Map.of("src", address(image), "alt", words), true);
        }

        private String address(Image image) {
            try {
                URL address = new URL("file:/pictures/" + pictures.size());
                pictures.put(address, image);
                return address.toString();
            } catch (MalformedURLException e) {
                throw new AssertionError("the scheme is known to every JDK", e);
            }
        }
    }
}
