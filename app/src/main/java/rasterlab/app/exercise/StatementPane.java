package rasterlab.app.exercise;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JEditorPane;
import javax.swing.UIManager;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;
import rasterlab.app.canvas.StageColours;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Picture;

/** What an exercise asks for, as a page. */
final class StatementPane extends JEditorPane {
    private static final long serialVersionUID = 1L;

    private static final int CELL = 14;

    private String shown = "";

    StatementPane(String accessibleName) {
        setName("statement");
        setEditable(false);
        setBackground(StageColours.now().ground());
        setEditorKit(new Kit());
        getAccessibleContext().setAccessibleName(accessibleName);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        setBorder(javax.swing.BorderFactory.createEmptyBorder(4, 12, 8, 12));
    }

    /** With a style of its own: setting one would give it to every label's HTML in the program. */
    private static final class Kit extends HTMLEditorKit {
        private static final long serialVersionUID = 1L;

        private transient StyleSheet own;

        @Override
        public StyleSheet getStyleSheet() {
            if (own == null) own = style(super.getStyleSheet());
            return own;
        }
    }

    private static StyleSheet style(StyleSheet usual) {
        var style = new StyleSheet();
        style.addStyleSheet(usual);
        String line = css(UIManager.getColor("Component.borderColor"));
        String code = css(StageColours.now().margin());
        int size = UIManager.getFont("Label.font").getSize();
        style.addRule("body { margin: 0 }");
        style.addRule("h1 { font-size: " + (size + 7) + "pt; margin: 6 0 6 0 }");
        style.addRule("h2 { font-size: " + (size + 2) + "pt; margin: 12 0 4 0 }");
        style.addRule("p { margin: 4 0 6 0 }");
        style.addRule("ul { margin-left: 18; margin-top: 2; margin-bottom: 4 }");
        style.addRule("li { margin: 2 0 2 0 }");
        style.addRule("body { font-size: " + size + "pt }");
        style.addRule(
                "code { font-family: Monospaced; font-size: "
                        + (size - 1)
                        + "pt; background-color: "
                        + code
                        + " }");
        style.addRule(
                "pre { font-family: Monospaced; font-size: "
                        + (size - 2)
                        + "pt; background-color: "
                        + code
                        + "; padding: 6 }");
        style.addRule("td { border: 1px solid " + line + "; vertical-align: top }");
        style.addRule("th { border: 1px solid " + line + "; text-align: left }");
        return style;
    }

    private static String css(Color colour) {
        return "#%06x".formatted(colour.getRGB() & 0xFFFFFF);
    }

    /** Shows the statement from its beginning, unless it is shown already. */
    void show(Exercise exercise, String language) {
        String markdown = exercise.statement(language);
        if (markdown.equals(shown)) return;
        shown = markdown;
        var statement = new Statement(markdown, new Pictures(exercise.pictures()));
        getDocument().putProperty("imageCache", statement.pictures());
        setText(statement.html());
        setCaretPosition(0);
    }

    private record Pictures(Map<String, Picture> named) implements Statement.Painter {
        @Override
        public Image pixels(List<String> rows) {
            return squares(rows);
        }

        @Override
        public Optional<Image> picture(String name) {
            return Optional.ofNullable(named.get(name)).flatMap(PicturePlate::of);
        }
    }

    /** One square for each character: {@code #} lit, {@code .} not. */
    private static Image squares(List<String> rows) {
        int cell = UIScale.scale(CELL);
        var colours = StageColours.now();
        var image =
                new BufferedImage(
                        rows.get(0).length() * cell + 1,
                        rows.size() * cell + 1,
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        for (int y = 0; y < rows.size(); y++)
            for (int x = 0; x < rows.get(y).length(); x++) {
                boolean lit = rows.get(y).charAt(x) == '#';
                g.setColor(lit ? colours.ink() : colours.ground());
                g.fillRect(x * cell, y * cell, cell, cell);
                g.setColor(colours.grid());
                g.drawRect(x * cell, y * cell, cell, cell);
            }
        g.dispose();
        return image;
    }
}
