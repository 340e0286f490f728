// Panel of the LIDAR service. MyRobotLab loads this script by its name; what the panel does is in modules, which come later.
angular.module('mrlapp.service.LIDARGui', []).controller('LIDARGuiCtrl', ['$scope', '$timeout', function($scope, $timeout) {
    var self = this
    import(new URL('service/js/sear/lidar/panel.js', document.baseURI)).then(function(panel) {
        if (!$scope.$$destroyed) {
            panel.open(self, $scope, $timeout)
        }
    }).catch(function(error) {
        $scope.failed = 'This panel could not be loaded: ' + error.message + '. Install SEAR again, then reload this page'
    }).then(function() {
        $scope.$applyAsync()
    })
}])
