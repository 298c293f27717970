package rasterlab.engine.scene.shape;

/**
 * Which blocks of a tessellation's cells become one face each, so that a mesh can be fine in one
 * place and coarse in another.
 */
public interface JoinedBlocks {
    /** Cells of a block each way, at least 2; the last block of a row or column may have fewer. */
    int side();

    /**
     * Whether a block is one face.
     *
     * @param patch number of the patch in {@link SceneShape#patches()}
     * @param column number of the block along u, from 0
     * @param row number of the block along v, from 0
     */
    boolean joined(int patch, int column, int row);

    /** How many blocks hold so many steps. */
    static int count(int steps, int side) {
        return (steps + side - 1) / side;
    }
}
