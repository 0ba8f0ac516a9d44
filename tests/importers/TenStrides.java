/** Runs a unit for ten strides in Co-Simulation through FMI4j and prints what it saw as one line of JSON. */
import java.io.File;
import no.ntnu.ihb.fmi4j.importer.fmi2.CoSimulationFmu;
import no.ntnu.ihb.fmi4j.importer.fmi2.Fmu;
import no.ntnu.ihb.fmi4j.SlaveInstance;

class TenStrides {
    static final double STEP = 0.1;
    static final int STEPS = 2510;

    /** Arguments: the unit, the value reference of stride.count, and those of the quantities. */
    public static void main(String[] arguments) throws Exception {
        long[] quantities = new long[arguments.length - 2];
        for (int i = 0; i < quantities.length; ++i) {
            quantities[i] = Long.parseLong(arguments[i + 2]);
        }
        double[] values = new double[quantities.length];
        int[] count = new int[1];
        try (CoSimulationFmu unit = Fmu.from(new File(arguments[0])).asCoSimulationFmu()) {
            SlaveInstance slave = unit.newInstance("runner", false, false);
            slave.simpleSetup();
            for (int i = 0; i < STEPS; ++i) {
                if (!slave.doStep(i * STEP, STEP)) {
                    throw new IllegalStateException("step " + i + " failed");
                }
            }
            slave.readReal(quantities, values);
            slave.readInteger(new long[] {Long.parseLong(arguments[1])}, count);
            slave.terminate();
        }
        StringBuilder line = new StringBuilder("RESULT [" + count[0]);
        for (double value : values) {
            line.append(", ").append(value);
        }
        System.out.println(line.append("]"));
    }
}
