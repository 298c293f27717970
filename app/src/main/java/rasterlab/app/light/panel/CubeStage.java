package rasterlab.app.light.panel;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.method.HazardNote;
import rasterlab.app.language.Texts;
import rasterlab.app.light.ColorChoice;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.mine.OwnMethods;

/** The colour cube, turned by mouse and arrow keys. */
final class CubeStage extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final double DRAG = Math.PI / 400;
    private static final double KEY = Math.PI / 36;

    /** The cube leaves room for so many lines below it where there is something to say. */
    private static final int NOTE_LINES = 4;

    private final transient LightLabModel model;
    private final transient Texts texts;

    CubeStage(LightLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        this.texts = texts;
        setName("cube");
        setFocusable(true);
        setOpaque(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
        getAccessibleContext().setAccessibleName(texts.text("cube"));
        getAccessibleContext().setAccessibleDescription(texts.text("cube.hint"));
        var mouse = new Turning();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        repaintOnFocus();
        bind(KeyEvent.VK_LEFT, -KEY, 0);
        bind(KeyEvent.VK_RIGHT, KEY, 0);
        bind(KeyEvent.VK_UP, 0, -KEY);
        bind(KeyEvent.VK_DOWN, 0, KEY);
    }

    private void bind(int key, double right, double down) {
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke(key, 0),
                () -> model.color(color -> color.turned(right, down)));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    /** The picture that is shown, as an SVG document. */
    SvgDrawing svg() {
        return SvgPicture.of(this, this::paintAll);
    }

    private void paintAll(Graphics2D g) {
        g.setColor(StageColors.now().margin());
        g.fillRect(0, 0, getWidth(), getHeight());
        var cube = (Graphics2D) g.create();
        String said = caption();
        int below = !said.isEmpty() ? NOTE_LINES * g.getFontMetrics().getHeight() : 0;
        int high = Math.max(1, getHeight() - below);
        new CubePainter(cube, model.state().color(), texts, getWidth(), high).paint();
        cube.dispose();
        if (!said.isEmpty()) Plates.sentenceAbove(g, said, getWidth(), getHeight() - 12);
    }

    /**
     * The words below the cube: of the hazard, else the reason why the user's program has no
     * answer.
     */
    private String caption() {
        Optional<HazardNote> note = model.state().note();
        if (note.isPresent()) return note.get().in(texts.language());
        ColorChoice color = model.state().color();
        if (!color.method().equals(OwnMethods.NAME)) return "";
        return model.ownTrips(color).map(trips -> trips.refusalIn(texts.language())).orElse("");
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        paintAll(g);
        frameFocus(g);
        g.dispose();
    }

    private final class Turning extends MouseAdapter {
        private Point last = new Point();

        @Override
        public void mousePressed(MouseEvent e) {
            requestFocusInWindow();
            last = e.getPoint();
            model.beginDrag();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            double right = (e.getX() - last.x) * DRAG;
            double down = (e.getY() - last.y) * DRAG;
            model.color(color -> color.turned(right, down));
            last = e.getPoint();
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            model.endDrag();
        }
    }
}
