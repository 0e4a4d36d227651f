import com.android.apksig.ApkSigner;
import com.android.apksig.ApkVerifier;
import java.io.File;
import java.io.FileInputStream;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.util.List;

/** Signs an APK and verifies what came of it: STORE PASSWORD MIN_SDK UNSIGNED SIGNED. */
public class Sign {
    public static void main(String[] arguments) throws Exception {
        char[] password = arguments[1].toCharArray();
        KeyStore store = KeyStore.getInstance("PKCS12");
        try (FileInputStream in = new FileInputStream(arguments[0])) {
            store.load(in, password);
        }
        PrivateKey key = (PrivateKey) store.getKey("debug", password);
        X509Certificate certificate = (X509Certificate) store.getCertificate("debug");
        File signed = new File(arguments[4]);
        int minSdk = Integer.parseInt(arguments[2]);
        new ApkSigner.Builder(List.of(new ApkSigner.SignerConfig.Builder("debug", key, List.of(certificate)).build()))
                .setInputApk(new File(arguments[3]))
                .setOutputApk(signed)
                .setMinSdkVersion(minSdk)
                .build()
                .sign();
        ApkVerifier.Result result = new ApkVerifier.Builder(signed).setMinCheckedPlatformVersion(minSdk).build().verify();
        if (!result.isVerified()) {
            throw new IllegalStateException(result.getErrors().toString());
        }
    }
}
