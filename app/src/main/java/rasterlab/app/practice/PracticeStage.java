package rasterlab.app.practice;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.ReadOut;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.Cell;
import rasterlab.app.practice.Board.Look;
import rasterlab.app.practice.Board.Run;

/**
 * The picture of a question, where the answer is clicked. By the keyboard a frame goes from pixel
 * to pixel; things in a plane are answered beside the picture.
 */
final class PracticeStage extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final Map<String, Point> ARROWS =
            Map.of(
                    "LEFT", new Point(-1, 0),
                    "RIGHT", new Point(1, 0),
                    "UP", new Point(0, -1),
                    "DOWN", new Point(0, 1));

    private final transient Texts texts;
    private final transient Consumer<StagePick> picked;
    private final ReadOut pointed = new ReadOut();
    private transient Optional<Board> board = Optional.empty();
    private boolean asking;

    /** The pixel that the frame is around. */
    private Point cursor = new Point();

    /** Where a run begins, while it is drawn. */
    private transient Optional<Point> begun = Optional.empty();

    /**
     * @param picked told what is answered in the picture
     */
    PracticeStage(Texts texts, Consumer<StagePick> picked) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.picked = picked;
        setName("practice.stage");
        setFocusable(true);
        repaintOnFocus();
        setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
        add(pointed);
        var mouse = new Pointer();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        ARROWS.forEach(
                (key, by) ->
                        KeyBinding.whenFocused(
                                this,
                                KeyStroke.getKeyStroke(key),
                                () -> move(new Point(cursor.x + by.x, cursor.y + by.y))));
        for (String key : List.of("ENTER", "SPACE"))
            KeyBinding.whenFocused(this, KeyStroke.getKeyStroke(key), this::confirm);
    }

    /**
     * Shows a board.
     *
     * @param fresh whether it is of another walk than the one before, to whose place the frame goes
     *     even from under the pointer
     * @param asking whether a click answers
     */
    void show(Board next, boolean fresh, boolean asking) {
        board = Optional.of(next);
        this.asking = asking;
        begun = Optional.empty();
        if (fresh || !pointed.isVisible()) move(newest(next));
        tell();
        repaint();
    }

    /** Whether pixels are answered here by the keyboard too. */
    boolean takesKeys() {
        return board.filter(each -> StagePick.isOfPixels(each.picking())).isPresent();
    }

    /** Where the walk is now; where it begins, if no step is made. */
    private static Point newest(Board board) {
        var found = new Point();
        for (Board.Figure figure : board.figures())
            if (figure instanceof Cell cell && cell.look() == Look.NEWEST)
                found = new Point(cell.x(), cell.y());
        return found;
    }

    private void move(Point pixel) {
        // A run stays in the row in which it began.
        cursor = begun.map(start -> new Point(pixel.x, start.y)).orElse(pixel);
        tell();
        repaint();
    }

    /** The key that answers: for a run the first time its beginning, then its end. */
    private void confirm() {
        if (!asking || !takesKeys()) {
            picked.accept(StagePick.NOTHING);
            return;
        }
        if (begun.isEmpty() && board.orElseThrow().picking() instanceof Run) {
            begun = Optional.of(cursor);
            repaint();
        } else end();
    }

    private void end() {
        Point from = begun.orElse(cursor);
        begun = Optional.empty();
        picked.accept(StagePick.pixels(board.orElseThrow().picking(), from, cursor));
    }

    /** Says where the frame is, also for those who do not see it. */
    private void tell() {
        String place = Shown.point(cursor.x, cursor.y, texts.locale());
        pointed.setText(place);
        getAccessibleContext()
                .setAccessibleName(
                        takesKeys() ? texts.text("stage.at", place) : texts.text("stage"));
    }

    private BoardFrame frame() {
        return BoardFrame.of(board.orElseThrow(), getSize());
    }

    @Override
    public void doLayout() {
        pointed.place(getHeight());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 560);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        StageColours colours = StageColours.now();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(colours.ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (board.isPresent()) paint(g, frame(), board.get(), colours);
        frameFocus(g);
        g.dispose();
    }

    private void paint(Graphics2D g, BoardFrame frame, Board shown, StageColours colours) {
        Font type = PictureType.in(getSize());
        frame.paintGrid(g, type, texts.locale());
        g.setFont(type);
        var painter = new BoardPainter(g, frame.map(), colours, texts);
        painter.paint(shown);
        if (asking && takesKeys()) {
            g.setColor(colours.focus());
            g.setStroke(new BasicStroke(3));
            Point from = begun.orElse(cursor);
            g.draw(painter.square(from.x, from.y).createUnion(painter.square(cursor.x, cursor.y)));
        }
        g.setStroke(new BasicStroke());
        frame.paintMargins(g, type, texts.locale());
    }

    /** Points at pixels and things, and clicks them. */
    private final class Pointer extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            if (board.isEmpty() || !asking) return;
            point(e);
            if (takesKeys() && board.get().picking() instanceof Run) begun = Optional.of(cursor);
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            if (board.isEmpty() || !asking || !contains(e.getPoint())) return;
            point(e);
            if (takesKeys()) end();
            else
                StagePick.plane(board.get().picking(), frame().map(), e.getPoint())
                        .ifPresent(picked);
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            point(e);
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            point(e);
        }

        @Override
        public void mouseExited(MouseEvent e) {
            pointed.setVisible(false);
        }

        private void point(MouseEvent e) {
            if (board.isEmpty()) return;
            BoardFrame frame = frame();
            if (takesKeys()) {
                move(frame.pixelAt(e.getPoint()));
            } else
                pointed.setText(
                        Shown.point(
                                frame.map().pointedX(e.getX()),
                                frame.map().pointedY(e.getY()),
                                texts.locale()));
            pointed.setVisible(true);
        }
    }
}
