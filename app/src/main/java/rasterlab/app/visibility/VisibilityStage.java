package rasterlab.app.visibility;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.Settling;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.language.Texts;
import rasterlab.engine.scene.Vase;

/** Shows the finished picture and turns the eye by keys, drag and wheel. */
final class VisibilityStage extends SelfDrawn implements Settling {
    private static final long serialVersionUID = 1L;

    /** Radians that one view unit of a drag turns. */
    private static final double DRAG = Math.PI / 400;

    private static final double WHEEL = 1.08;
    private static final double ZOOM = 1.25;

    private final transient VisibilityLabModel model;

    VisibilityStage(VisibilityLabModel model, Texts texts) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        setName("stage");
        setFocusable(true);
        setOpaque(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
        getAccessibleContext().setAccessibleName(texts.text("stage"));
        getAccessibleContext().setAccessibleDescription(texts.text("stage.hint"));
        var mouse = new Turning();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        repaint();
                    }

                    @Override
                    public void focusLost(FocusEvent e) {
                        repaint();
                    }
                });
        bind(KeyEvent.VK_UP, 0, Vase.PHI_STEP);
        bind(KeyEvent.VK_DOWN, 0, -Vase.PHI_STEP);
        bind(KeyEvent.VK_LEFT, -Vase.THETA_STEP, 0);
        bind(KeyEvent.VK_RIGHT, Vase.THETA_STEP, 0);
        for (String key : new String[] {"typed +", "typed ="})
            KeyBinding.whenFocused(
                    this,
                    KeyStroke.getKeyStroke(key),
                    () -> model.choose(choice -> choice.zoomed(ZOOM)));
        KeyBinding.whenFocused(
                this,
                KeyStroke.getKeyStroke("typed -"),
                () -> model.choose(choice -> choice.zoomed(1 / ZOOM)));
    }

    private void bind(int key, double dTheta, double dPhi) {
        KeyBinding.whenFocused(
                this, KeyStroke.getKeyStroke(key, 0), () -> model.turn(dTheta, dPhi));
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
    }

    /** The picture is as large as the stage, in the screen's own dots. */
    @Override
    public void doLayout() {
        double scale = DevicePixels.scale(this);
        model.resize(DevicePixels.count(getWidth(), scale), DevicePixels.count(getHeight(), scale));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setColor(StageColours.now().ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        VisibilityLabState state = model.state();
        state.difference()
                .map(difference -> difference.mask().image())
                .or(() -> state.picture().map(picture -> picture.raster().image()))
                .ifPresent(image -> DevicePixels.paint(g, image));
        g.dispose();
        paintFocus((Graphics2D) graphics.create());
    }

    /** Blue between two white lines, so that it is seen on any picture. */
    private void paintFocus(Graphics2D g) {
        if (isFocusOwner()) {
            g.setColor(Color.WHITE);
            g.setStroke(new BasicStroke(4));
            g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
            g.setColor(StageColours.LIGHT.focus());
            g.setStroke(new BasicStroke(2));
            g.drawRect(2, 2, getWidth() - 4, getHeight() - 4);
        }
        g.dispose();
    }

    /** One drag turns the eye as one change for undo. */
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
            model.turn((last.x - e.getX()) * DRAG, (last.y - e.getY()) * DRAG);
            last = e.getPoint();
        }

        @Override
        public void mouseReleased(MouseEvent e) {
            model.endDrag();
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            double turned = e.getPreciseWheelRotation();
            if (e.isControlDown()) model.choose(choice -> choice.zoomed(Math.pow(ZOOM, -turned)));
            else model.retreat(Math.pow(WHEEL, turned));
        }
    }
}
