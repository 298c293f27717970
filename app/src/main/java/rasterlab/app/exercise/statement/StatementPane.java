package rasterlab.app.exercise.statement;

import com.formdev.flatlaf.util.UIScale;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.JEditorPane;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.work.Settling;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.StatementPicture;
import rasterlab.exercises.formula.Formulas;
import rasterlab.exercises.formula.TexFormula;
import rasterlab.exercises.formula.Typeset;

/** The statement of an exercise, as a page. */
public final class StatementPane extends JEditorPane implements Settling {
    private static final long serialVersionUID = 1L;

    private static final int CELL = 14;

    private final transient Formulas formulas;
    private final transient Consumer<Throwable> onFailure;
    private final StatementKit kit = new StatementKit();
    private String shown = "";
    private transient volatile CompletableFuture<Void> setting =
            CompletableFuture.completedFuture(null);

    /**
     * @param onFailure told what kept formulas from being set, on any thread
     */
    public StatementPane(String accessibleName, Formulas formulas, Consumer<Throwable> onFailure) {
        this.formulas = formulas;
        this.onFailure = onFailure;
        setName("statement");
        setEditable(false);
        setBackground(StageColors.now().ground());
        setEditorKit(kit);
        getAccessibleContext().setAccessibleName(accessibleName);
        putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
        setBorder(javax.swing.BorderFactory.createEmptyBorder(4, 12, 8, 12));
    }

    /**
     * Shows the statement from its beginning, unless it is shown already, and of what is new below
     * it the end. Formulas stand there as their authors wrote them until they are set in the
     * background.
     *
     * @param below in Markdown, what stands below the statement
     */
    public void show(Exercise exercise, String language, String below) {
        String markdown = exercise.statement(language) + below;
        if (markdown.equals(shown)) return;
        boolean goesOn = !shown.isEmpty() && markdown.startsWith(shown);
        shown = markdown;
        List<TexFormula> awaited = put(exercise, language);
        setCaretPosition(0);
        if (goesOn) showEnd();
        if (awaited.isEmpty()) return;
        setting =
                CompletableFuture.runAsync(() -> awaited.forEach(formulas::set))
                        .thenRunAsync(
                                () -> {
                                    if (markdown.equals(shown))
                                        putAgain(exercise, language, goesOn);
                                },
                                EventQueue::invokeLater);
        setting.exceptionally(
                failure -> {
                    onFailure.accept(failure);
                    return null;
                });
    }

    /** Loads what statements are set with, by setting one that is not shown; on any thread. */
    public static void prepare(Exercise exercise, Formulas formulas) {
        statement(exercise, exercise.statement("en"), "en", formulas);
    }

    private static Statement statement(
            Exercise exercise, String markdown, String language, Formulas formulas) {
        return new Statement(
                markdown, language, new Pictures(exercise.pictures(), language, formulas));
    }

    /** The formulas that are not set yet. */
    private List<TexFormula> put(Exercise exercise, String language) {
        Statement statement = statement(exercise, shown, language, formulas);
        kit.setFormulas(statement.formulas().drawn());
        getDocument().putProperty("imageCache", statement.pictures());
        setText(statement.html());
        return statement.formulas().awaited();
    }

    private void putAgain(Exercise exercise, String language, boolean goesOn) {
        Rectangle seen = getVisibleRect();
        put(exercise, language);
        setCaretPosition(0);
        if (goesOn) showEnd();
        else EventQueue.invokeLater(() -> scrollRectToVisible(seen));
    }

    /** Scrolls to the end, which may lie below the height that the text had before. */
    private void showEnd() {
        EventQueue.invokeLater(
                () -> scrollRectToVisible(new Rectangle(0, getPreferredSize().height - 1, 1, 1)));
    }

    @Override
    public void settle() throws InterruptedException {
        try {
            setting.get();
        } catch (ExecutionException e) {
            throw new IllegalStateException("formulas were not set", e);
        }
    }

    private record Pictures(Map<String, StatementPicture> named, String language, Formulas formulas)
            implements Statement.StatementPainter {
        @Override
        public Optional<Typeset> formula(TexFormula formula) {
            return formulas.known(formula);
        }

        @Override
        public Image pixels(List<String> rows) {
            return squares(rows);
        }

        @Override
        public Optional<Image> picture(String name) {
            return Optional.ofNullable(named.get(name))
                    .flatMap(one -> PicturePlate.of(one, language));
        }
    }

    /** One square for each character: {@code #} lit, {@code .} not. */
    private static Image squares(List<String> rows) {
        int cell = UIScale.scale(CELL);
        var colors = StageColors.now();
        var image =
                new BufferedImage(
                        rows.get(0).length() * cell + 1,
                        rows.size() * cell + 1,
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        for (int y = 0; y < rows.size(); y++)
            for (int x = 0; x < rows.get(y).length(); x++) {
                boolean lit = rows.get(y).charAt(x) == '#';
                g.setColor(lit ? colors.ink() : colors.ground());
                g.fillRect(x * cell, y * cell, cell, cell);
                g.setColor(colors.grid());
                g.drawRect(x * cell, y * cell, cell, cell);
            }
        g.dispose();
        return image;
    }
}
