package rasterlab.engine.texture;

import java.util.ArrayList;
import java.util.List;

/**
 * The shares of which {@link TextureSampler}'s filters mix a colour: the texels that they look up,
 * in their order, and how much each counts. A repeated texture.
 */
public final class TexelShares {
    private static final int BITS = 8;
    private static final int WHOLE = 1 << BITS;

    private final Texture texture;
    private final int highest;

    public TexelShares(Texture texture) {
        this.texture = texture;
        highest = texture.levelCount() - 1;
    }

    /** Shares of {@link TextureSampler#nearest(double, double)}. */
    public List<TexelShare> nearest(double s, double t) {
        return nearestOf(0, s, t);
    }

    private List<TexelShare> nearestOf(int number, double s, double t) {
        TextureLevel level = texture.level(number);
        int i = Math.min(level.width() - 1, (int) (Wrap.REPEAT.within(s) * level.width()));
        int j = Math.min(level.height() - 1, (int) (Wrap.REPEAT.within(t) * level.height()));
        return List.of(new TexelShare(number, i, j, 1, level.texel(i, j)));
    }

    /** Shares of {@link TextureSampler#linear(double, double)}. */
    public List<TexelShare> linear(double s, double t) {
        var shares = new ArrayList<TexelShare>();
        addLinear(0, s, t, 1, shares);
        return shares;
    }

    private void addLinear(int number, double s, double t, double whole, List<TexelShare> shares) {
        TextureLevel level = texture.level(number);
        int u = (int) (Wrap.REPEAT.within(s) * level.width() * WHOLE + 0.5) - WHOLE / 2;
        int v = (int) (Wrap.REPEAT.within(t) * level.height() * WHOLE + 0.5) - WHOLE / 2;
        double right = (double) (u & WHOLE - 1) / WHOLE;
        double above = (double) (v & WHOLE - 1) / WHOLE;
        for (int up = 0; up <= 1; up++)
            for (int across = 0; across <= 1; across++) {
                int i = Wrap.REPEAT.index((u >> BITS) + across, level.width());
                int j = Wrap.REPEAT.index((v >> BITS) + up, level.height());
                double share =
                        (across == 0 ? 1 - right : right) * (up == 0 ? 1 - above : above) * whole;
                shares.add(new TexelShare(number, i, j, share, level.texel(i, j)));
            }
    }

    /** Shares of {@link TextureSampler#nearestLevel}. */
    public List<TexelShare> nearestLevel(double s, double t, double lambda) {
        return nearestOf((int) (within(lambda) + 0.5), s, t);
    }

    /** Shares of {@link TextureSampler#trilinear(double, double, double)}. */
    public List<TexelShare> trilinear(double s, double t, double lambda) {
        double level = within(lambda);
        int finer = (int) level;
        double coarser = Math.floor((level - finer) * WHOLE + 0.5) / WHOLE;
        var shares = new ArrayList<TexelShare>();
        if (coarser == 0 || finer == highest) addLinear(finer, s, t, 1, shares);
        else {
            addLinear(finer, s, t, 1 - coarser, shares);
            addLinear(finer + 1, s, t, coarser, shares);
        }
        return shares;
    }

    private double within(double lambda) {
        return lambda > 0 ? Math.min(lambda, highest) : 0;
    }
}
