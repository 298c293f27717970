package rasterlab.engine.scene;

/**
 * The three tables of the house, row k for vertex k + 1, written out.
 *
 * <p>World: metres times 16. Eye: turned about x by −90°, about y by −40°, about x by 10°. Screen:
 * shifted by −150 along y and divided by 1 − z/700. The textbook gives the vertices and the steps;
 * the numbers follow from them point by point, in thirty digits and without matrices: (y, z) to (y
 * cos − z sin, y sin + z cos) about x, (x, z) to (x cos + z sin, z cos − x sin) about y.
 */
public final class HouseTables {
    private HouseTables() {}

    public static double[][] world() {
        return new double[][] {
            {0, 0, 0},
            {128, 0, 0},
            {128, 96, 0},
            {0, 96, 0},
            {0, 0, 80},
            {128, 0, 80},
            {128, 96, 80},
            {0, 96, 80},
            {64, 0, 144},
            {64, 96, 144}
        };
    }

    public static double[][] eye() {
        return new double[][] {
            {0, 0, 0},
            {98.0536887192, -14.2872188223, 81.0268443596},
            {159.7612992491, -1.5170855526, 8.603819713},
            {61.7076105299, 12.7701332697, -72.4230246466},
            {0, 78.784620241, 13.8918542134},
            {98.0536887192, 64.4974014187, 94.918698573},
            {159.7612992491, 77.2675346884, 22.4956739264},
            {61.7076105299, 91.5547535107, -58.5311704333},
            {49.0268443596, 134.6687070226, 65.5187597638},
            {110.7344548895, 147.4388402923, -6.9042648828}
        };
    }

    public static double[][] screen() {
        return new double[][] {
            {0, -150, 0},
            {110.889432729, -185.7932805771, 91.6336848131},
            {161.7493886472, -153.4025829341, 8.7108867113},
            {55.9218536898, -124.3630803926, -65.6325816748},
            {0, -72.6573006565, 14.1731270924},
            {113.4353052087, -98.9153339654, 109.8085312575},
            {165.0659710507, -75.1474547966, 23.2426143162},
            {56.9460149492, -53.9353874135, -54.0146811368},
            {54.0895283822, -16.9144560999, 72.2844568543},
            {109.6529222886, -2.5361451111, -6.8368316023}
        };
    }
}
