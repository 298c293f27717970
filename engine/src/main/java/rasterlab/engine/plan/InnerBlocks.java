package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.plan.BlockBounds.BlockBound;
import rasterlab.engine.scene.shape.JoinedBlocks;

/**
 * The blocks of a shape's cells that are coarser without being seen to be: those that are on the
 * outline for no camera of a range.
 *
 * <p>A face that is d off the surface shows at a pixel what is d/cos θ aside on the surface, θ
 * being the angle between the normal and the line of sight, so that the normal there is off by as
 * much times the rate at which it turns. Near the outline cos θ is 0, and cells stay as they are:
 * the outline keeps its fine steps. On a convex body, of which nothing hides another place that
 * faces the eye, the same normal is also seen within the pixels that the rise takes: there it may
 * be off by what mixing it from corners loses, alone.
 */
final class InnerBlocks implements JoinedBlocks {
    /** Meshes of fewer faces are as fine within the outline as on it. */
    private static final int FEW = 1024;

    /** Sides of blocks that are tried, in cells. */
    private static final int[] SIDES = {32, 24, 16, 12, 8, 6, 4, 3, 2};

    /** Blocks that may be measured: of a mesh of more, only larger ones are. */
    private static final int MOST_BLOCKS = 8192;

    /** Pictures that a mesh with its outline holds for, at half a degree each. */
    private static final int PICTURES = 16;

    /** Time to make a face of such a mesh and to look at it. */
    private static final double FACE_MILLISECONDS = 1e-3;

    /** The share of pictures that making their meshes may take: it saves several times that. */
    private static final double MAKING = 0.08;

    /** The share of the faces that must be saved. */
    private static final double SAVED = 0.3;

    /**
     * A divisor of φ², φ being what a step turns by: the rise times the rate is φ²/8, and where a
     * quarter of that is too much, no block is measured.
     */
    private static final double HOPELESS = 32;

    private final BlockBounds bounds;
    private final List<BitSet> joined = new ArrayList<>();

    /** Cells and blocks: about as many faces as are made of them. */
    private int faces;

    private double levels;
    private double sag;

    /**
     * How far apart from the full picture a joined block may be.
     *
     * @param full the steps of the full picture
     * @param convex whether the shape encloses a convex body
     * @param levelsPerRadian for each radian that a normal is off
     * @param sag the most that both meshes together may be off the surface, world units
     * @param levels the most that may be seen of it
     */
    record Allowed(
            ShapeSteps full, boolean convex, double levelsPerRadian, double sag, double levels) {
        /** Whether blocks as large as these steps would nowhere be close enough. */
        boolean hopeless(ShapeSteps blocks) {
            double turned = blocks.mixed();
            if (!convex) turned = Math.max(turned, blocks.turn() * blocks.turn() / HOPELESS);
            return blocks.sag() > sag || turned * levelsPerRadian > levels;
        }
    }

    /**
     * The blocks that leave the fewest faces; empty where they save too little, or where making
     * their mesh takes too much of the pictures that it holds for.
     *
     * @param least the steps that the outline needs
     * @param milliseconds that the full picture takes
     */
    static Optional<InnerBlocks> fewest(
            ShapePart part, ShapeSteps least, EyeRange eye, Allowed allowed, double milliseconds) {
        double fewest =
                Math.min(
                        MAKING * PICTURES * milliseconds / FACE_MILLISECONDS,
                        (1 - SAVED) * least.faces());
        Optional<InnerBlocks> best = Optional.empty();
        for (int side : SIDES) {
            if (least.faces() < FEW || least.faces() > (long) MOST_BLOCKS * side * side) break;
            if (allowed.hopeless(part.atLeast(least.u() / side, least.v() / side))) continue;
            var blocks = new InnerBlocks(part.blocks(least.u(), least.v(), side), eye, allowed);
            if (blocks.faces > fewest) continue;
            fewest = blocks.faces;
            best = Optional.of(blocks);
        }
        return best;
    }

    private InnerBlocks(BlockBounds bounds, EyeRange eye, Allowed allowed) {
        this.bounds = bounds;
        for (int patch = 0; patch < bounds.blocks().size(); patch++) {
            List<BlockBound> blocks = bounds.blocks().get(patch);
            var bits = new BitSet(blocks.size());
            for (int k = 0; k < blocks.size(); k++) {
                BlockBound block = blocks.get(k);
                double seen = seen(block, eye, allowed);
                boolean coarser = seen <= allowed.levels;
                faces += coarser ? 1 : block.cells();
                if (!coarser) continue;
                bits.set(k);
                levels = Math.max(levels, seen);
                sag = Math.max(sag, block.sag());
            }
            joined.add(bits);
        }
    }

    /** The levels by which a joined block may look different; +∞ where it must not be joined. */
    private static double seen(BlockBound block, EyeRange eye, Allowed allowed) {
        double off = block.sag() + allowed.full.sag();
        double cosine = eye.leastCosine(block);
        if (off > allowed.sag || !(cosine > 0)) return Double.POSITIVE_INFINITY;
        double aside = allowed.convex ? 0 : off / cosine * block.rate();
        return (block.mixed() + allowed.full.mixed() + aside) * allowed.levelsPerRadian;
    }

    @Override
    public int side() {
        return bounds.side();
    }

    @Override
    public boolean joined(int patch, int column, int row) {
        return joined.get(patch).get(row * bounds.columns() + column);
    }

    /** The levels by which joined blocks may look different, the most of all. */
    double levels() {
        return levels;
    }

    /** The largest distance of a joined block from the surface, world units. */
    double sag() {
        return sag;
    }
}
