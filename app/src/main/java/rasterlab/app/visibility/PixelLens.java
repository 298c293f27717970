package rasterlab.app.visibility;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.Raster;

/** The pixels around the chosen one, enlarged, wrong ones marked by shape. */
final class PixelLens extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = 9;
    private static final int SIDE = 15;

    private final transient VisibilityLabModel model;

    PixelLens(VisibilityLabModel model, String said) {
        super(AccessibleRole.CANVAS);
        this.model = model;
        setName("lens");
        getAccessibleContext().setAccessibleName(said);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(20 * SIDE), UIScale.scale(ROWS * SIDE));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, getPreferredSize().height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        VisibilityLabState state = model.state();
        if (state.chosen().isEmpty() || state.picture().isEmpty()) return;
        ChosenPixel at = state.chosen().get();
        Optional<Picture> picture = at.second() ? state.other() : state.picture();
        if (picture.isEmpty() || !picture.get().raster().contains(at.x(), at.y())) return;
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Optional<Compared> compared = at.second() ? state.otherDifference() : state.difference();
        if (!state.choice().difference()) compared = Optional.empty();
        paint(g, at, picture.get().raster(), compared);
        g.dispose();
    }

    private void paint(Graphics2D g, ChosenPixel at, Raster raster, Optional<Compared> compared) {
        int side = UIScale.scale(SIDE);
        int columns = getWidth() / side;
        columns -= 1 - columns % 2;
        int left = (getWidth() - columns * side) / 2;
        for (int j = 0; j < ROWS; j++)
            for (int i = 0; i < columns; i++) {
                int x = at.x() + i - columns / 2;
                int y = at.y() + j - ROWS / 2;
                if (!raster.contains(x, y)) continue;
                g.setColor(new Color(raster.argb(x, y)));
                g.fillRect(left + i * side, j * side, side, side);
                if (compared.isPresent() && compared.get().exact().contains(x, y))
                    mark(g, compared.get().at(x, y), left + i * side, j * side, side);
            }
        g.setColor(StageColors.now().ground());
        g.drawRect(left + columns / 2 * side - 1, ROWS / 2 * side - 1, side + 1, side + 1);
        g.setColor(StageColors.now().focus());
        g.drawRect(left + columns / 2 * side, ROWS / 2 * side, side - 1, side - 1);
    }

    private static void mark(Graphics2D g, Compared.PixelFault wrong, int x, int y, int side) {
        switch (wrong) {
            case MISSING -> PixelMark.MISSING.paint(g, x, y, side);
            case EXTRA -> PixelMark.EXTRA.paint(g, x, y, side);
            case COLOR -> WrongFaceIcon.paint(g, x, y, side);
            case NOTHING -> {}
        }
    }
}
