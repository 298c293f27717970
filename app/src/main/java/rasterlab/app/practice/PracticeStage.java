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
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.ReadOut;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.ZoomButtons;
import rasterlab.app.canvas.Zooming;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.Picking;
import rasterlab.app.practice.Board.RunPick;

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
    private final ZoomButtons zoom;
    private transient Optional<Board> board = Optional.empty();
    private transient Optional<PlaneMap> chosen = Optional.empty();
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
        zoom = new ZoomButtons(Texts.of("canvas", texts.language()), this, new Zoom());
        add(zoom);
        add(pointed);
        var mouse = new Pointer();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
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
        if (fresh) chosen = Optional.empty();
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
        for (Board.BoardFigure figure : board.figures())
            if (figure instanceof BoardCell cell && cell.look() == FigureLook.NEWEST)
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
        if (begun.isEmpty() && board.orElseThrow().picking() instanceof RunPick) {
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
        BoardFrame whole = BoardFrame.of(board.orElseThrow(), getSize());
        return chosen.map(whole::by).orElse(whole);
    }

    /** Brings the middle nearer, by notches of the wheel. */
    void zoom(int notches) {
        var middle = new Point(getWidth() / 2, getHeight() / 2);
        if (board.isPresent()) look(frame().zoomed(ZoomButtons.factor(-notches), middle));
    }

    /** Shows everything again, and keeps doing so when the stage changes its size. */
    void fit() {
        chosen = Optional.empty();
        repaint();
    }

    /** Puts another part of the board in sight. */
    private void look(PlaneMap next) {
        chosen = Optional.of(next);
        repaint();
    }

    @Override
    public void doLayout() {
        zoom.place();
        pointed.place(getHeight());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 560);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        StageColors colors = StageColors.now();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(colors.ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (board.isPresent()) paint(g, frame(), board.get(), colors);
        frameFocus(g);
        g.dispose();
    }

    private void paint(Graphics2D g, BoardFrame frame, Board shown, StageColors colors) {
        Font type = PictureType.in(getSize());
        frame.paintGrid(g, type, texts.locale());
        g.setFont(type);
        var painter = new BoardPainter(g, frame.map(), colors, texts);
        painter.paint(shown);
        if (asking && takesKeys()) {
            g.setColor(colors.focus());
            g.setStroke(new BasicStroke(3));
            Point from = begun.orElse(cursor);
            g.draw(painter.square(from.x, from.y).createUnion(painter.square(cursor.x, cursor.y)));
        }
        g.setStroke(new BasicStroke());
        frame.paintMargins(g, type, texts.locale());
    }

    private final class Zoom implements Zooming {
        @Override
        public void zoom(double factor, Point2D view) {
            if (board.isPresent()) look(frame().zoomed(factor, view));
        }

        @Override
        public void fit() {
            PracticeStage.this.fit();
        }
    }

    /**
     * Points at pixels and things, and clicks them; the other buttons move the picture, and the
     * wheel zooms it.
     */
    private final class Pointer extends MouseAdapter {
        private Point last = new Point();

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            last = e.getPoint();
            if (board.isEmpty() || !asking || !isLeft(e)) return;
            point(e);
            if (board.get().picking() instanceof RunPick) begun = Optional.of(cursor);
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            if (board.isEmpty() || !asking || !isLeft(e) || !contains(e.getPoint())) return;
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
            if (board.isPresent() && !isLeft(e))
                look(frame().map().moved(e.getX() - last.x, e.getY() - last.y));
            last = e.getPoint();
            point(e);
        }

        /** Brings everything back, where a click is no answer. */
        @Override
        public void mouseClicked(MouseEvent e) {
            if (board.isEmpty()) return;
            if (e.getClickCount() == 2 && !(asking && isLeft(e) && answers(e.getPoint()))) fit();
        }

        private boolean answers(Point at) {
            Picking picking = board.orElseThrow().picking();
            return takesKeys() || StagePick.plane(picking, frame().map(), at).isPresent();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            if (board.isPresent())
                look(frame().zoomed(ZoomButtons.factor(e.getPreciseWheelRotation()), e.getPoint()));
        }

        private static boolean isLeft(MouseEvent e) {
            return SwingUtilities.isLeftMouseButton(e);
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
            pointed.setVisible(frame.space() != Board.BoardSpace.SPACE);
        }
    }
}
