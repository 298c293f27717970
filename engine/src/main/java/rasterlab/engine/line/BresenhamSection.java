package rasterlab.engine.line;

/**
 * {@link BresenhamLine}'s loop from where the line enters a window, with d = r − 2·n there, r being
 * the {@link LineSection#remainder}.
 */
final class BresenhamSection implements LineWalk {
    private final int alongX;
    private final int alongY;
    private final int acrossX;
    private final int acrossY;
    private final long straight;
    private final long diagonal;
    private int x;
    private int y;
    private long d;
    private long left;

    BresenhamSection(int x0, int y0, LineSection section) {
        alongX = section.steep() ? 0 : section.signX();
        alongY = section.steep() ? section.signY() : 0;
        acrossX = section.signX() - alongX;
        acrossY = section.signY() - alongY;
        straight = 2 * section.b();
        diagonal = straight - 2 * section.n();
        x = section.x(x0) - alongX;
        y = section.y(y0) - alongY;
        d = section.remainder() - 2 * section.n();
        left = section.count();
    }

    @Override
    public boolean advance() {
        if (left == 0) return false;
        left--;
        if (d >= 0) {
            d += diagonal;
            x += acrossX;
            y += acrossY;
        } else {
            d += straight;
        }
        x += alongX;
        y += alongY;
        return true;
    }

    @Override
    public int x() {
        return x;
    }

    @Override
    public int y() {
        return y;
    }

    @Override
    public double decision() {
        return d;
    }
}
